// OpenMesh's readers tell an importer what they read. A half-edge mesh as the importer would refuse faces at complex
// edges and flipped neighbours; this one keeps every face as it is told.
#include "hatchway/io/meshes/raw_mesh.hpp"

#include <fmt/format.h>

#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <OpenMesh/Core/IO/reader/OBJReader.hh>
#include <OpenMesh/Core/IO/reader/OFFReader.hh>
#include <OpenMesh/Core/IO/reader/PLYReader.hh>
#include <OpenMesh/Core/IO/reader/STLReader.hh>
#include <istream>
#include <locale>
#include <mutex>
#include <streambuf>
#include <utility>

#include "hatchway/core/error.hpp"

namespace hw {
namespace {

namespace io = OpenMesh::IO;
using OpenMesh::EdgeHandle;
using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;
using Status = OpenMesh::Attributes::StatusInfo;

constexpr float kByte = 1.0f / 255.0f;

/// Collects what a reader tells. `corner_attributes`: normals are told corner by corner, before their face.
class Collector final : public io::BaseImporter {
 public:
    Collector(const CheckedMesh& mesh, bool corner_attributes, RawMesh& raw)
        : checked_(mesh), has_corner_attributes_(corner_attributes), raw_(raw)
    {
        raw.face_ends.reserve(mesh.faces);
        raw.corners.reserve(3 * mesh.faces);
    }

    VertexHandle add_vertex(const OpenMesh::Vec3f& point) override
    {
        raw_.positions.emplace_back(point[0], point[1], point[2]);
        return VertexHandle(static_cast<int>(raw_.positions.size()) - 1);
    }
    VertexHandle add_vertex() override { return add_vertex(OpenMesh::Vec3f(0.0f)); }
    void set_point(VertexHandle vertex, const OpenMesh::Vec3f& point) override
    {
        raw_.positions[index(vertex)] = {point[0], point[1], point[2]};
    }
    void set_normal(VertexHandle vertex, const OpenMesh::Vec3f& normal) override
    {
        const glm::vec3 value(normal[0], normal[1], normal[2]);
        if (has_corner_attributes_)
            waiting_normals_.push_back(value);
        else
            at(raw_.normals, vertex, glm::vec3(0.0f)) = value;
    }
    void set_normal(VertexHandle vertex, const OpenMesh::Vec3d& normal) override
    {
        set_normal(vertex, OpenMesh::Vec3f(normal));
    }
    void set_color(VertexHandle vertex, const OpenMesh::Vec3uc& c) override
    {
        at(raw_.colours, vertex, glm::vec4(1.0f)) = colour_of(c);
    }
    void set_color(VertexHandle vertex, const OpenMesh::Vec4uc& c) override
    {
        at(raw_.colours, vertex, glm::vec4(1.0f)) = colour_of(c);
    }
    void set_color(VertexHandle vertex, const OpenMesh::Vec3f& c) override
    {
        at(raw_.colours, vertex, glm::vec4(1.0f)) = {c[0], c[1], c[2], 1.0f};
    }
    void set_color(VertexHandle vertex, const OpenMesh::Vec4f& c) override
    {
        at(raw_.colours, vertex, glm::vec4(1.0f)) = {c[0], c[1], c[2], c[3]};
    }
    void set_texcoord(VertexHandle vertex, const OpenMesh::Vec2f& uv) override
    {
        at(raw_.uv, vertex, glm::vec2(0.0f)) = {uv[0], uv[1]};
    }

    FaceHandle add_face(const VHandles& vertices) override
    {
        for (const VertexHandle vertex : vertices) raw_.corners.push_back(static_cast<std::uint32_t>(index(vertex)));
        raw_.face_ends.push_back(static_cast<std::uint32_t>(raw_.corners.size()));
        if (waiting_normals_.size() == vertices.size()) {
            raw_.corner_normals.resize(raw_.corners.size() - vertices.size(), glm::vec3(0.0f));
            raw_.corner_normals.insert(raw_.corner_normals.end(), waiting_normals_.begin(), waiting_normals_.end());
        }
        waiting_normals_.clear();
        return FaceHandle(static_cast<int>(raw_.face_ends.size()) - 1);
    }
    void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<OpenMesh::Vec2f>& uv) override
    {
        if (uv.empty()) return;
        raw_.corner_uv.resize(raw_.corners.size() - uv.size(), glm::vec2(0.0f));
        for (const OpenMesh::Vec2f& corner : uv) raw_.corner_uv.emplace_back(corner[0], corner[1]);
    }
    void set_color(FaceHandle face, const OpenMesh::Vec3uc& c) override { face_colour(face) = colour_of(c); }
    void set_color(FaceHandle face, const OpenMesh::Vec4uc& c) override { face_colour(face) = colour_of(c); }

    std::size_t n_vertices() const override { return raw_.positions.size(); }
    std::size_t n_faces() const override { return raw_.face_ends.size(); }
    std::size_t n_edges() const override { return 0; }

    // What these four readers never tell, or what is not kept.
    HalfedgeHandle add_edge(VertexHandle, VertexHandle) override { return HalfedgeHandle(); }
    FaceHandle add_face(HalfedgeHandle) override { return FaceHandle(); }
    void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<OpenMesh::Vec3f>&) override {}
    void set_face_texindex(FaceHandle, int) override {}
    void set_halfedge(VertexHandle, HalfedgeHandle) override {}
    void set_status(VertexHandle, const Status&) override {}
    void set_next(HalfedgeHandle, HalfedgeHandle) override {}
    void set_face(HalfedgeHandle, FaceHandle) override {}
    void request_face_texcoords2D() override {}
    void set_texcoord(HalfedgeHandle, const OpenMesh::Vec2f&) override {}
    void set_texcoord(VertexHandle, const OpenMesh::Vec3f&) override {}
    void set_texcoord(HalfedgeHandle, const OpenMesh::Vec3f&) override {}
    void set_status(HalfedgeHandle, const Status&) override {}
    void set_color(EdgeHandle, const OpenMesh::Vec3uc&) override {}
    void set_color(EdgeHandle, const OpenMesh::Vec4uc&) override {}
    void set_color(EdgeHandle, const OpenMesh::Vec3f&) override {}
    void set_color(EdgeHandle, const OpenMesh::Vec4f&) override {}
    void set_status(EdgeHandle, const Status&) override {}
    void set_normal(FaceHandle, const OpenMesh::Vec3f&) override {}
    void set_normal(FaceHandle, const OpenMesh::Vec3d&) override {}
    void set_color(FaceHandle, const OpenMesh::Vec3f&) override {}
    void set_color(FaceHandle, const OpenMesh::Vec4f&) override {}
    void set_status(FaceHandle, const Status&) override {}
    void add_texture_information(int, std::string) override {}

 private:
    /// The check has seen every index; that a reader tells another is our mistake.
    std::size_t index(VertexHandle vertex) const
    {
        const auto result = static_cast<std::size_t>(vertex.idx());
        HW_ASSERT(vertex.idx() >= 0 && result < (checked_.vertices > 0 ? checked_.vertices : raw_.positions.size()));
        return result;
    }
    template <typename T>
    T& at(std::vector<T>& stream, VertexHandle vertex, const T& none)
    {
        if (stream.empty()) stream.resize(checked_.vertices, none);
        return stream[index(vertex)];
    }
    glm::vec4& face_colour(FaceHandle face)
    {
        if (raw_.face_colours.size() < n_faces()) raw_.face_colours.resize(n_faces(), glm::vec4(1.0f));
        return raw_.face_colours[static_cast<std::size_t>(face.idx())];
    }
    static glm::vec4 colour_of(const OpenMesh::Vec3uc& c) { return kByte * glm::vec4(c[0], c[1], c[2], 255.0f); }
    static glm::vec4 colour_of(const OpenMesh::Vec4uc& c) { return kByte * glm::vec4(c[0], c[1], c[2], c[3]); }

    const CheckedMesh& checked_;
    bool has_corner_attributes_;
    RawMesh& raw_;
    std::vector<glm::vec3> waiting_normals_;
};

/// A stream over bytes in memory, which readers may move in.
class MemoryBuffer final : public std::streambuf {
 public:
    explicit MemoryBuffer(std::string& text) { setg(text.data(), text.data(), text.data() + text.size()); }

 protected:
    pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode) override
    {
        const off_type base = from == std::ios_base::beg   ? 0
                              : from == std::ios_base::cur ? gptr() - eback()
                                                           : egptr() - eback();
        const off_type target = base + offset;
        if (target < 0 || target > egptr() - eback()) return pos_type(off_type(-1));
        setg(eback(), eback() + target, egptr());
        return pos_type(target);
    }
    pos_type seekpos(pos_type position, std::ios_base::openmode mode) override
    {
        return seekoff(off_type(position), std::ios_base::beg, mode);
    }
};

/// Readers make streams of their own, in the locale of the process: a decimal comma would end numbers at their point.
class ClassicLocale {
 public:
    ClassicLocale()
    {
        if (before_ != std::locale::classic()) std::locale::global(std::locale::classic());
    }
    ~ClassicLocale()
    {
        if (before_ != std::locale::classic()) std::locale::global(before_);
    }
    ClassicLocale(const ClassicLocale&) = delete;
    ClassicLocale& operator=(const ClassicLocale&) = delete;

 private:
    std::locale before_;
};

io::BaseReader& reader_of(MeshFormat format)
{
    switch (format) {
        case MeshFormat::obj:
            return io::OBJReader();
        case MeshFormat::ply:
            return io::PLYReader();
        case MeshFormat::stl:
            return io::STLReader();
        case MeshFormat::off:
            break;
    }
    return io::OFFReader();
}

/// What OpenMesh is asked for: it tells nothing of its own accord.
io::Options options_of(MeshFormat format, const CheckedMesh& mesh)
{
    io::Options options;
    if (mesh.is_binary) options += io::Options::Binary;
    if (mesh.has_normals) options += io::Options::VertexNormal;
    if (mesh.has_colours) options += io::Options::VertexColor;
    if (mesh.has_face_colours) options += io::Options::FaceColor;
    if (mesh.has_uv) options += format == MeshFormat::obj ? io::Options::FaceTexCoord : io::Options::VertexTexCoord;
    return options;
}

}  // namespace

RawMesh read_raw_mesh(MeshFormat format, CheckedMesh& mesh, const std::string& name)
{
    RawMesh raw;
    Collector collector(mesh, format == MeshFormat::obj, raw);
    MemoryBuffer buffer(mesh.text);
    io::Options options = options_of(format, mesh);
    bool is_read = false;
    {
        // OpenMesh's readers are objects of the process that keep what they read in a header.
        static std::mutex one_at_a_time;
        const std::lock_guard lock(one_at_a_time);
        const ClassicLocale locale;
        std::istream stream(&buffer);
        is_read = reader_of(format).read(stream, collector, options);
    }
    const bool has_all_vertices = format == MeshFormat::stl || raw.positions.size() == mesh.vertices;
    if (!is_read || !has_all_vertices || raw.face_ends.size() != mesh.faces)
        throw Error({.what = fmt::format("{} vertices and {} faces of {} and {} could be read", raw.positions.size(),
                                         raw.face_ends.size(), mesh.vertices, mesh.faces),
                     .file = name});
    if (!raw.corner_normals.empty()) raw.corner_normals.resize(raw.corners.size(), glm::vec3(0.0f));
    if (!raw.corner_uv.empty()) raw.corner_uv.resize(raw.corners.size(), glm::vec2(0.0f));
    if (!raw.face_colours.empty()) raw.face_colours.resize(raw.face_ends.size(), glm::vec4(1.0f));
    if (!mesh.normals.empty()) raw.normals = std::move(mesh.normals);
    if (!mesh.colours.empty() && mesh.has_colours) raw.colours = std::move(mesh.colours);
    if (!mesh.face_colours.empty() && mesh.has_face_colours) raw.face_colours = std::move(mesh.face_colours);
    return raw;
}

}  // namespace hw

#include "hatchway/render/lines/edge_store.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <set>

#include "hatchway/core/progress.hpp"

namespace hw {
namespace {

constexpr std::size_t kJobsTogether = 64;  // their vertices are in memory twice until they are on the device

}  // namespace

EdgeStore::EdgeStore(const Scene& scene, LineIndices& indices)
    : scene_(scene), indices_(indices), surfaces_(scene), objects_(scene.objects.size())
{
}

void EdgeStore::prepare(std::span<const EdgeDemand> demands)
{
    std::vector<ObjectId> wanted;
    for (ObjectId object = 0; object < demands.size(); ++object)
        if (demands[object].is_any()) wanted.push_back(object);
    std::vector<ObjectMeshes> objects(scene_.objects.size());
    if (!wanted.empty()) {
        surfaces_.build(wanted);
        const LineExtras extras = find_line_extras(scene_, demands, surfaces_);
        std::vector<Job> jobs = jobs_of(demands, extras);
        run(jobs);
        objects = meshes_of(demands, extras, jobs);
    }
    objects_ = std::move(objects);
}

EdgeStore::Key EdgeStore::key_of(ObjectId object, float crease_rad) const
{
    return {surfaces_.key_of(object), surfaces_.is_culled(object), crease_rad};
}

std::vector<EdgeStore::Job> EdgeStore::jobs_of(std::span<const EdgeDemand> demands, const LineExtras& extras) const
{
    std::vector<Job> jobs;
    std::set<Key> planned;
    for (ObjectId object = 0; object < demands.size(); ++object) {
        for (const float crease_rad : demands[object].crease_rad) {
            const ObjectExtras& own = extras.objects[object];
            const Key key = key_of(object, crease_rad);
            if (own.is_empty() && (shared_lines_.contains(key) || !planned.insert(key).second)) continue;
            jobs.push_back({.object = object, .crease_rad = crease_rad, .extras = own, .mesh = nullptr});
        }
    }
    return jobs;
}

void EdgeStore::run(std::span<Job> jobs)
{
    if (jobs.empty()) return;
    Progress progress("Preparing lines", jobs.size());
    for (std::size_t first = 0; first < jobs.size(); first += kJobsTogether) {
        const std::span<Job> together = jobs.subspan(first, std::min(kJobsTogether, jobs.size() - first));
        std::vector<LineMeshData> data(together.size());
        tbb::parallel_for(std::size_t{0}, together.size(), [&](std::size_t i) {
            const Job& job = together[i];
            data[i] = line_mesh_data(
                {*surfaces_.find(job.object), job.crease_rad, job.extras, surfaces_.is_culled(job.object)});
            progress.advance();
        });
        for (std::size_t i = 0; i < together.size(); ++i) {
            together[i].mesh = std::make_unique<LineMesh>(upload(std::move(data[i]), indices_));
            ++line_meshes_built_;
        }
    }
}

std::vector<EdgeStore::ObjectMeshes> EdgeStore::meshes_of(std::span<const EdgeDemand> demands, const LineExtras& extras,
                                                          std::span<Job> done)
{
    std::vector<ObjectMeshes> objects(scene_.objects.size());
    for (Job& job : done) {
        if (job.extras.is_empty())
            shared_lines_[key_of(job.object, job.crease_rad)] = std::move(job.mesh);
        else
            objects[job.object].own.push_back(std::move(job.mesh));
    }
    for (ObjectId object = 0; object < demands.size(); ++object) {
        if (!demands[object].is_any()) continue;
        ObjectMeshes& meshes = objects[object];
        meshes.surface = surfaces_.find(object);
        auto own = meshes.own.begin();
        for (const float crease_rad : demands[object].crease_rad) {
            const bool is_shared = extras.objects[object].is_empty();
            meshes.lines.emplace_back(crease_rad,
                                      is_shared ? shared_lines_.at(key_of(object, crease_rad)).get() : (own++)->get());
        }
    }
    return objects;
}

const LineMesh* EdgeStore::lines(ObjectId object, float crease_rad) const
{
    for (const auto& [own_rad, lines] : objects_[object].lines)
        if (own_rad == crease_rad) return lines;
    return nullptr;
}

double EdgeStore::line_length(ObjectId object) const
{
    double longest = 0.0;
    for (const auto& [own_rad, lines] : objects_[object].lines)
        if (lines != nullptr) longest = std::max(longest, lines->length);
    return longest;
}

}  // namespace hw

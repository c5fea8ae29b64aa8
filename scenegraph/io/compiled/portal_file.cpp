#include "hatchway/io/compiled/portal_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <numeric>

#include "hatchway/core/error.hpp"
#include "hatchway/core/files/files.hpp"
#include "hatchway/core/limits.hpp"

namespace hw {
namespace {

constexpr int kMostLeaves = 200'000;
constexpr int kMostPortals = 2'000'000;
constexpr int kMostCorners = 1024;
constexpr double kMostCoordinate = 1e9;

/// Words of the text; parentheses stand for spaces.
class Words {
 public:
    Words(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    std::string_view next(std::string_view expected)
    {
        skip_gap();
        const std::size_t begin = at_;
        while (at_ < text_.size() && !is_gap(text_[at_])) ++at_;
        if (begin == at_) fail("the text ends", expected);
        return text_.substr(begin, at_ - begin);
    }

    void end()
    {
        skip_gap();
        if (at_ < text_.size()) fail(fmt::format("found \"{}\"", next("")), "the end of the text");
    }

    int whole(int least, int most, std::string_view meaning)
    {
        const std::string_view word = next(meaning);
        int value = 0;
        const auto [stop, status] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (status != std::errc() || stop != word.data() + word.size() || value < least || value > most) {
            fail(fmt::format("found \"{}\"", word),
                 fmt::format("{}, a whole number from {} to {}", meaning, least, most));
        }
        return value;
    }

    double real(std::string_view meaning)
    {
        const std::string_view word = next(meaning);
        double value = 0.0;
        const auto [stop, status] = std::from_chars(word.data(), word.data() + word.size(), value);
        const bool is_number = status == std::errc() && stop == word.data() + word.size() && std::isfinite(value);
        if (!is_number || std::abs(value) > kMostCoordinate) fail(fmt::format("found \"{}\"", word), meaning);
        return value;
    }

    [[noreturn]] void fail(std::string what, std::string_view expected) const
    {
        const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n');
        throw Error({.what = std::move(what),
                     .file = file_,
                     .pointer = fmt::format("line {}", line),
                     .expected = std::string(expected)});
    }

 private:
    static bool is_gap(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t' || c == '(' || c == ')'; }
    void skip_gap()
    {
        while (at_ < text_.size() && is_gap(text_[at_])) ++at_;
    }

    std::string_view text_;
    std::string file_;
    std::size_t at_ = 0;
};

glm::dvec3 area_vector(const std::vector<glm::dvec3>& winding)
{
    glm::dvec3 sum(0.0);
    for (std::size_t i = 2; i < winding.size(); ++i) {
        sum += glm::cross(winding[i - 1] - winding[0], winding[i] - winding[0]);
    }
    return sum;
}

void read_portal(Words& words, PortalFile& result)
{
    DirectedPortal portal;
    const int corners = words.whole(3, kMostCorners, "corners of a portal");
    portal.from_leaf = words.whole(0, result.graph.leaf_count - 1, "the portal's first leaf");
    portal.to_leaf = words.whole(0, result.graph.leaf_count - 1, "the portal's second leaf");
    if (portal.from_leaf == portal.to_leaf)
        words.fail(fmt::format("the portal leads from leaf {} to itself", portal.from_leaf), "two leaves");
    for (int i = 0; i < corners; ++i) {
        glm::dvec3 corner;
        for (int axis = 0; axis < 3; ++axis) corner[axis] = words.real("a coordinate");
        portal.winding.push_back(corner);
    }
    const glm::dvec3& first = portal.winding[0];
    if (std::all_of(portal.winding.begin(), portal.winding.end(), [&](const glm::dvec3& c) { return c == first; }))
        words.fail("all corners of the portal are one point", "a polygon");
    const glm::dvec3 area = area_vector(portal.winding);
    const double size = glm::length(area);
    if (!(size > 1e-9)) {
        ++result.portals_without_area;
        return;
    }
    portal.normal = area / size;
    portal.offset = -glm::dot(portal.normal, portal.winding[0]);
    DirectedPortal back = portal;
    std::swap(back.from_leaf, back.to_leaf);
    back.normal = -portal.normal;
    back.offset = -portal.offset;
    std::reverse(back.winding.begin(), back.winding.end());
    result.graph.portals.push_back(std::move(portal));
    result.graph.portals.push_back(std::move(back));
}

/// PRT2 ends with a line for each cluster: its leaves, then -1.
void read_clusters(Words& words, PortalFile& result)
{
    const int leaves = static_cast<int>(result.cluster_of_leaf.size());
    for (int cluster = 0; cluster < result.graph.leaf_count; ++cluster)
        for (int leaf = 0; (leaf = words.whole(-1, leaves - 1, "a leaf of the cluster, or -1")) != -1;)
            result.cluster_of_leaf[leaf] = cluster;
}

}  // namespace

PortalFile parse_portals(std::string_view text, const std::string& file)
{
    Words words(text, file);
    const std::string_view magic = words.next("PRT1 or PRT2");
    if (magic != "PRT1" && magic != "PRT2") words.fail(fmt::format("found \"{}\"", magic), "PRT1 or PRT2");
    PortalFile result;
    const int leaves = words.whole(1, kMostLeaves, "the number of leaves");
    const bool has_clusters = magic == "PRT2";
    result.graph.leaf_count = has_clusters ? words.whole(1, kMostLeaves, "the number of clusters") : leaves;
    result.portals_in_file = words.whole(0, kMostPortals, "the number of portals");
    for (int i = 0; i < result.portals_in_file; ++i) read_portal(words, result);
    result.cluster_of_leaf.resize(leaves);
    if (has_clusters) {
        read_clusters(words, result);
    } else {
        std::iota(result.cluster_of_leaf.begin(), result.cluster_of_leaf.end(), 0);
    }
    words.end();
    return result;
}

PortalFile read_portal_file(const std::filesystem::path& file)
{
    return parse_portals(read_text_file(file, limits::kMaxFileBytes), file.string());
}

std::string portals_text(const PortalGraph& graph)
{
    // The opening back is written with the opening there: the lower leaf comes first.
    std::vector<const DirectedPortal*> written;
    for (const DirectedPortal& portal : graph.portals) {
        const bool has_opposite =
            std::any_of(graph.portals.begin(), graph.portals.end(), [&](const DirectedPortal& other) {
                return other.from_leaf == portal.to_leaf && other.to_leaf == portal.from_leaf &&
                       other.winding.size() == portal.winding.size() &&
                       std::is_permutation(other.winding.begin(), other.winding.end(), portal.winding.begin());
            });
        if (portal.from_leaf < portal.to_leaf || !has_opposite) written.push_back(&portal);
    }
    std::string text = fmt::format("PRT1\n{}\n{}\n", graph.leaf_count, written.size());
    for (const DirectedPortal* portal : written) {
        fmt::format_to(std::back_inserter(text), "{} {} {} ", portal->winding.size(), portal->from_leaf,
                       portal->to_leaf);
        for (const glm::dvec3& corner : portal->winding) {
            fmt::format_to(std::back_inserter(text), "({} {} {}) ", corner.x, corner.y, corner.z);
        }
        text += '\n';
    }
    return text;
}

}  // namespace hw

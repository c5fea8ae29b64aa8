#include "hatchway/drawing/line_looks.hpp"

#include "hatchway/drawing/frame_items.hpp"

namespace hw {
namespace {

/// A pass that draws nothing and writes down each LineLook.
class LookRecorder final : public Pass {
 public:
    LookRecorder(const View& view, const FrameItems& made, float crease_rad, std::vector<ObjectPens>& pens)
        : view_(view), made_(made), crease_rad_(crease_rad), pens_(pens)
    {
    }

    const View& view() const override { return view_; }
    Layer layer() const override { return Layer::opaque; }
    Items opaque_scene() const override { return {}; }
    DepthRange depth_range(const ImageKey&) const override { return {}; }
    void cover(Program, const Uniforms&) override {}
    Image image(const ImageKey&, std::size_t) const override { return {}; }
    Images render(const TargetDesc&, Program, const Uniforms&, Items) override { return {}; }
    Images filter(const TargetDesc&, Program, const Uniforms&) override { return {}; }
    void surfaces(Program, const Uniforms&, Items) override {}
    void lines(Program, const Uniforms&, const LineLook& look, Items items) override { lines(look, items); }
    void lines(const LineLook& look, Items items) override
    {
        for (const DrawItem& item : items)
            if (made_.has_made(item))
                pens_[FrameItems::slot(item)].looks.push_back({look, crease_rad_, FrameItems::presence(item),
                                                               FrameItems::is_presence_inverted(item), view_.time_s});
    }

 private:
    const View& view_;
    const FrameItems& made_;
    float crease_rad_;
    std::vector<ObjectPens>& pens_;
};

}  // namespace

std::vector<ObjectPens> object_pens(const Scene& scene, std::span<const NamedStyle> styles,
                                    std::span<const StyledObject> objects, const View& view)
{
    std::vector<Needs> needs;
    for (const NamedStyle& style : styles) needs.push_back(style.style->needs());
    std::vector<ObjectPens> pens(objects.size());
    const std::vector<EdgeDemand> demands = edge_demands(objects, needs);
    for (ObjectId id = 0; id < objects.size(); ++id) pens[id].edges = demands[id];
    FrameItems made;
    for (int style = 0; style < static_cast<int>(styles.size()); ++style) {
        if (!needs[style].edges) continue;
        std::vector<DrawItem> items;
        for (ObjectId id = 0; id < objects.size(); ++id) {
            if (objects[id].style == style) items.push_back(made.make(scene, id, objects[id], false, id));
            if (objects[id].over == style) items.push_back(made.make(scene, id, objects[id], true, id));
        }
        LookRecorder recorder(view, made, needs[style].edges->crease_rad, pens);
        if (!items.empty()) styles[style].style->lines(recorder, items);
    }
    return pens;
}

}  // namespace hw

#pragma once

#include "hatchway/drawing/styled_object.hpp"

namespace hw {

/// What the host alone knows of an item.
struct ItemPlace {
    std::uint32_t slot = 0;  ///< The host's own index of the item.
    PresenceField presence = {};
    bool is_presence_inverted = false;  ///< The style shows 1 - presence: another style of the object shows presence.
};

/// Makes the items of one frame and knows them again: the host's side of DrawItem. Styles hand items back in their own
/// memory, so whatever comes back is asked about before anything in it is followed.
class FrameItems {
 public:
    /// No two frames of a process are taken for each other.
    FrameItems();

    DrawItem make(const ItemFacts& facts, const ItemPlace& place);
    /// What a style sees of an object that it draws: `is_over`, as the object's second style.
    DrawItem make(const Scene& scene, ObjectId id, const StyledObject& look, bool is_over, std::uint32_t slot);
    /// Whether make() made it, so that its slot is one that was given.
    bool has_made(const DrawItem& item) const { return item.frame_ == frame_ && item.slot_ < slots_; }

    static std::uint32_t slot(const DrawItem& item) { return item.slot_; }
    static const PresenceField& presence(const DrawItem& item) { return item.presence_; }
    static bool is_presence_inverted(const DrawItem& item) { return item.is_presence_inverted_; }

 private:
    std::uint64_t frame_;
    std::uint32_t slots_ = 0;  ///< All that were given are below.
};

}  // namespace hw

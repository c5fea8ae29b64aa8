#include "hatchway/walk/style_edits.hpp"

#include <gtest/gtest.h>

#include <random>

#include "hatchway/world/looks.hpp"

namespace {

const std::vector<std::string> kStyles{"assumed", "excavated", "mixed"};

/// Hall (plank, stone) > Column_01, Column_02 (stone); Column_02 > Capital (gold).
hw::Scene hall()
{
    hw::Scene scene;
    scene.nodes = {{.name = "Hall", .path = "Hall"},
                   {.name = "Column_01", .path = "Hall/Column_01", .parent = 0},
                   {.name = "Column_02", .path = "Hall/Column_02", .parent = 0},
                   {.name = "Capital", .path = "Hall/Column_02/Capital", .parent = 2}};
    scene.materials = {{.name = "Plank"}, {.name = "Stone"}, {.name = "Gold"}};
    scene.meshes.resize(1);
    scene.objects = {{0, 0, 0, {}}, {0, 0, 1, {}}, {1, 0, 1, {}}, {2, 0, 1, {}}, {3, 0, 2, {}}};
    return scene;
}

std::vector<hw::StyleChoice> choices(hw::Level level, const hw::Scene& scene, const std::vector<hw::AssignRule>& rules)
{
    level.assign.insert(level.assign.end(), rules.begin(), rules.end());
    std::vector<hw::StyleChoice> result;
    for (const auto& look : hw::resolve_looks(level, scene, "assumed")) result.push_back(hw::choice_of(look));
    return result;
}

std::vector<hw::StyleChoice> after(const hw::Level& level, const hw::Scene& scene,
                                   const std::map<hw::ObjectId, hw::StyleChoice>& wanted)
{
    return choices(level, scene, hw::rules_for(level, scene, "assumed", wanted));
}

hw::Scene random_scene(std::mt19937& random)
{
    const auto below = [&](int n) { return static_cast<int>(random() % n); };
    hw::Scene scene;
    scene.materials = {{.name = "Plank"}, {.name = "Stone [old]*"}, {.name = ""}, {.name = "Pl?nk"}};
    const int node_count = 1 + below(8);
    for (int i = 0; i < node_count; ++i) {
        hw::Node node;
        node.parent = i == 0 ? hw::kNone : below(i + 1) - 1;
        const std::string names[] = {"A", "B", "[x]", "#" + std::to_string(i)};
        node.name = names[below(4)];
        node.path = (node.parent == hw::kNone ? "" : scene.nodes[node.parent].path + '/') + node.name;
        scene.nodes.push_back(node);
        for (int k = below(4); k > 0; --k) scene.objects.push_back({.node = i, .mesh = 0, .material = below(4)});
    }
    return scene;
}

bool cannot_be_told_apart(const hw::Scene& scene, hw::ObjectId a, hw::ObjectId b)
{
    const auto& name = [&](hw::ObjectId id) { return scene.materials[scene.objects[id].material].name; };
    return scene.objects[a].node == scene.objects[b].node && name(a) == name(b);
}

}  // namespace

TEST(style_rules, an_edit_of_one_object_leaves_its_neighbours_and_children_alone)
{
    const hw::Scene scene = hall();
    hw::Level level;
    const auto looks = after(level, scene, {{3, {.style = "excavated"}}});
    EXPECT_EQ(looks[3].style, "excavated");
    for (const int other : {0, 1, 2, 4}) EXPECT_EQ(looks[other].style, "assumed") << other;
}

TEST(style_rules, one_of_two_materials_on_a_node_is_named_by_its_material)
{
    const hw::Scene scene = hall();
    const auto rules = hw::rules_for({}, scene, "assumed", {{1, {.style = "excavated"}}});
    ASSERT_FALSE(rules.empty());
    EXPECT_EQ(rules[0].nodes, "Hall");
    EXPECT_EQ(rules[0].materials, "Stone");
}

TEST(style_rules, a_leaf_node_needs_one_short_rule)
{
    const auto rules = hw::rules_for({}, hall(), "assumed", {{2, {.style = "excavated"}}});
    ASSERT_EQ(rules.size(), 1u);
    EXPECT_EQ(rules[0].nodes, "Hall/Column_01");
    EXPECT_EQ(rules[0].materials, "");
}

TEST(style_rules, what_the_level_already_says_needs_no_rule)
{
    EXPECT_TRUE(hw::rules_for({}, hall(), "assumed", {{2, {.style = "assumed"}}}).empty());
}

TEST(style_rules, a_hybrid_look_can_be_restored_in_full)
{
    const hw::StyleChoice rising{"assumed", "excavated", {.height = hw::Ramp{2.0f, 0.5f}}, true};
    const hw::Scene scene = hall();
    EXPECT_EQ(after({}, scene, {{2, rising}})[2], rising);
}

TEST(style_rules, repeated_paths_are_named_by_index)
{
    hw::Scene scene = hall();
    scene.nodes[2].path = "Hall/Column_01";
    EXPECT_EQ(hw::node_selector(scene, 1), "#1");
    EXPECT_EQ(hw::node_selector(scene, 3), "Hall/Column_02/Capital");
    const auto looks = after({}, scene, {{3, {.style = "excavated"}}});
    EXPECT_EQ(looks[3].style, "excavated");
    EXPECT_EQ(looks[2].style, "assumed");
}

TEST(style_rules, on_random_scenes_exactly_the_wanted_objects_change)
{
    std::mt19937 random(5);
    for (int round = 0; round < 2000; ++round) {
        const hw::Scene scene = random_scene(random);
        if (scene.objects.empty()) continue;
        hw::Level level;
        level.assign = {{.nodes = "*", .style = "assumed"}, {.materials = "Pl*", .style = "mixed", .over = "assumed"}};
        const auto before = choices(level, scene, {});
        const auto object = static_cast<hw::ObjectId>(random() % scene.objects.size());
        const hw::StyleChoice wanted{kStyles[random() % 3], random() % 2 ? "" : "excavated", {.constant = 0.5f}, true};
        const auto now = after(level, scene, {{object, wanted}});
        for (hw::ObjectId other = 0; other < now.size(); ++other)
            EXPECT_EQ(now[other], cannot_be_told_apart(scene, object, other) ? wanted : before[other])
                << "round " << round << " object " << object << " other " << other;
        if (HasFailure()) break;
    }
}

TEST(style_edits, undo_and_redo_walk_the_same_way)
{
    hw::StyleEdits edits;
    edits.push({7, {.style = "assumed"}, {.style = "excavated"}});
    edits.push({7, {.style = "excavated"}, {.style = "mixed"}});
    EXPECT_EQ(edits.unsaved().at(7).style, "mixed");
    EXPECT_EQ(edits.undo()->after.style, "mixed");
    EXPECT_EQ(edits.unsaved().at(7).style, "excavated");
    edits.undo();
    EXPECT_TRUE(edits.unsaved().empty());
    EXPECT_FALSE(edits.undo().has_value());
    edits.redo();
    edits.redo();
    EXPECT_EQ(edits.unsaved().at(7).style, "mixed");
    EXPECT_FALSE(edits.redo().has_value());
}

TEST(style_edits, doing_again_what_was_undone_changes_nothing)
{
    std::mt19937 random(7);
    const auto state = [](const hw::StyleEdits& edits) { return std::pair(edits.unsaved(), edits.has_unsaved()); };
    const auto choice = [&] { return hw::StyleChoice{.style = kStyles[random() % kStyles.size()]}; };
    int undone = 0;
    for (int trial = 0; trial < 200; ++trial) {
        hw::StyleEdits edits;
        for (int step = 0; step < 40; ++step) {
            switch (random() % 5) {
                case 0:
                    edits.undo();
                    break;
                case 1:
                    edits.redo();
                    break;
                case 2:
                    if (random() % 4 == 0) edits.mark_saved();
                    break;
                default:
                    edits.push({static_cast<hw::ObjectId>(random() % 4), choice(), choice()});
            }
            hw::StyleEdits moved = edits;
            if (const auto taken_back = moved.undo()) {
                const auto again = moved.redo();
                ASSERT_TRUE(again);
                EXPECT_EQ(again->object, taken_back->object);
                EXPECT_TRUE(again->after == taken_back->after && again->before == taken_back->before);
                EXPECT_EQ(state(moved), state(edits));
                ++undone;
            }
            moved = edits;
            if (moved.redo()) {
                ASSERT_TRUE(moved.undo());
                EXPECT_EQ(state(moved), state(edits));
            }
        }
    }
    EXPECT_GT(undone, 4000);
}

TEST(style_edits, a_new_step_ends_the_way_forward)
{
    hw::StyleEdits edits;
    edits.push({1, {.style = "assumed"}, {.style = "excavated"}});
    edits.undo();
    edits.push({2, {.style = "assumed"}, {.style = "mixed"}});
    EXPECT_FALSE(edits.redo().has_value());
    EXPECT_EQ(edits.unsaved().size(), 1u);
}

TEST(style_edits, knows_whether_the_file_says_the_same)
{
    hw::StyleEdits edits;
    EXPECT_FALSE(edits.has_unsaved());
    edits.push({1, {.style = "assumed"}, {.style = "excavated"}});
    EXPECT_TRUE(edits.has_unsaved());
    edits.mark_saved();
    EXPECT_FALSE(edits.has_unsaved());
    edits.undo();
    EXPECT_TRUE(edits.has_unsaved());
    edits.redo();
    EXPECT_FALSE(edits.has_unsaved());
}

TEST(style_edits, what_was_saved_is_left_to_the_file)
{
    hw::StyleEdits edits;
    edits.push({1, {.style = "assumed"}, {.style = "excavated"}});
    edits.mark_saved();
    EXPECT_TRUE(edits.unsaved().empty()) << "another editor may change it now";
}

TEST(style_edits, a_saved_step_that_is_undone_and_cut_off_still_has_to_be_told_to_the_file)
{
    hw::StyleEdits edits;
    edits.push({1, {.style = "assumed"}, {.style = "excavated"}});
    edits.mark_saved();
    edits.undo();
    edits.push({2, {.style = "assumed"}, {.style = "mixed"}});
    EXPECT_TRUE(edits.has_unsaved());
    EXPECT_EQ(edits.unsaved().at(1).style, "assumed");
    EXPECT_EQ(edits.unsaved().at(2).style, "mixed");
    edits.undo();
    EXPECT_TRUE(edits.has_unsaved());
    edits.mark_saved();
    EXPECT_FALSE(edits.has_unsaved());
}

TEST(style_edits, an_edit_undone_after_saving_is_told_to_the_file)
{
    hw::StyleEdits edits;
    edits.push({2, {.style = "assumed"}, {.style = "excavated"}});
    edits.mark_saved();
    edits.undo();
    hw::Level saved;
    saved.assign = {{.nodes = "Hall/Column_01", .style = "excavated"}};
    EXPECT_EQ(after(saved, hall(), edits.unsaved())[2].style, "assumed");
}

TEST(style_edits, follow_their_objects_into_a_changed_model)
{
    hw::Scene changed = hall();
    changed.objects.erase(changed.objects.begin());  // the hall's planks are gone: all numbers move by one
    const auto new_of_old = hw::matching_objects(hw::object_keys(hall()), hw::object_keys(changed));
    EXPECT_EQ(new_of_old.count(0), 0u);
    EXPECT_EQ(new_of_old.at(3), 2u);
    hw::StyleEdits edits;
    edits.push({0, {.style = "assumed"}, {.style = "excavated"}});
    edits.push({3, {.style = "assumed"}, {.style = "mixed"}});
    edits.renumber(new_of_old);
    EXPECT_EQ(edits.unsaved().size(), 1u);
    EXPECT_EQ(edits.unsaved().at(2).style, "mixed");
    EXPECT_TRUE(edits.undo().has_value());
    EXPECT_FALSE(edits.undo().has_value());
}

TEST(style_cycle, goes_round_both_ways_and_starts_at_the_first)
{
    EXPECT_EQ(hw::next_style(kStyles, "mixed", 1), "assumed");
    EXPECT_EQ(hw::next_style(kStyles, "assumed", -1), "mixed");
    EXPECT_EQ(hw::next_style(kStyles, "unheard_of", 1), "assumed");
}

TEST(object_name, tells_the_material_only_where_it_is_needed)
{
    EXPECT_EQ(hw::object_name(hall(), 0), "Hall (Plank)");
    EXPECT_EQ(hw::object_name(hall(), 2), "Hall/Column_01");
}

TEST(style_edits, a_hidden_parent_s_rule_leaves_the_children_as_they_are)
{
    const hw::Scene scene = hall();
    for (hw::ObjectId object = 0; object < scene.objects.size(); ++object) {
        hw::Level level;
        level.assign = hw::rules_for({}, scene, "assumed", {{object, {.style = "", .visible = false}}});
        const auto looks = hw::resolve_looks(level, scene, "assumed");
        for (hw::ObjectId other = 0; other < looks.size(); ++other) {
            const bool is_alike = scene.objects[other].node == scene.objects[object].node &&
                                  scene.materials[scene.objects[other].material].name ==
                                      scene.materials[scene.objects[object].material].name;
            EXPECT_EQ(looks[other].is_visible, !is_alike) << object << ' ' << other;
            EXPECT_TRUE(looks[other].style_pointer.empty()) << "nothing is said of styles";
        }
    }
}

TEST(style_edits, hiding_and_a_style_of_one_object_are_both_unsaved_and_undone_one_by_one)
{
    hw::StyleEdits edits;
    edits.push({7, {.style = "assumed"}, {.style = "excavated"}});
    edits.push({7, {.style = "", .visible = true}, {.style = "", .visible = false}});
    EXPECT_EQ(edits.unsaved().at(7), (hw::StyleChoice{.style = "excavated", .visible = false}));
    edits.undo();
    EXPECT_EQ(edits.unsaved().at(7), (hw::StyleChoice{.style = "excavated"}));
    edits.redo();
    edits.mark_saved();
    edits.undo();
    EXPECT_EQ(edits.unsaved().at(7), (hw::StyleChoice{.style = "", .visible = true}));
}

TEST(style_edits, edits_that_belong_together_are_undone_and_redone_together)
{
    hw::StyleEdits edits;
    edits.push({1, {.style = "a"}, {.style = "b"}});
    edits.push({2, {.style = "a"}, {.style = "c"}});
    edits.push({3, {.style = "a"}, {.style = "c"}, true});
    EXPECT_EQ(edits.undo()->object, 2u);
    EXPECT_EQ(edits.unsaved().size(), 1u);
    EXPECT_EQ(edits.redo()->object, 2u);
    EXPECT_EQ(edits.unsaved().size(), 3u);
}

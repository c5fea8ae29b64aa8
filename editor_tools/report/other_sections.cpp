#include "report/other_sections.hpp"

namespace hw {
namespace {

ReportSection game_map_section()
{
    return {.name = "game_map",
            .title = "A game's map: the share that its own PVS leaves, and ours",
            .judge = "Nothing: what either of the two hides is not looked at here.",
            .leaves_out =
                "Other maps. The game's compiler, q3map2, is told by the map's makers which brushes hide; ours gets "
                "triangles. The two cut the map into other parts, so only the shares compare.",
            .says =
                "Views from the starts and items of an OpenArena map, four directions each: triangles that the PVS "
                "stored in the map leaves of those in view, and what ours leaves of the same map as a model "
                "(editor_tools/measure/visibility/game_map_share.py).",
            .arguments = {},
            .plots = {}};
}

ReportSection devices_section()
{
    return {.name = "devices",
            .title = "Other devices",
            .judge = "The same views drawn by llvmpipe, by the same engine: what both draw wrongly is not seen.",
            .leaves_out =
                "Drivers of graphics cards: none has drawn these views. Times. The driver of each device is the one "
                "that the machine had.",
            .says =
                "Pixels that differ by more than 16 of 255 (unlike), of how many that are not paper (inked), and the "
                "largest difference of one pixel: softpipe, ANGLE on SwiftShader, and --as-hardware beside "
                "--as-software (tests/program/second_device_test.cpp).",
            .arguments = {},
            .plots = {}};
}

ReportSection fuzz_section()
{
    return {.name = "fuzz",
            .title = "Files of strangers",
            .judge = "The address and undefined-behaviour sanitizers, and limits of memory and time for each input.",
            .leaves_out =
                "Whether what was read is right. Inputs above 64 KiB. The campaign goes on while readers are mended, "
                "so no one commit got all of it: CPU seconds stand by commit.",
            .says =
                "Inputs that libFuzzer tried on each reader, CPU seconds, branches that some input took (edges), and "
                "ends that were no success (faults), which stay counted when they are mended "
                "(tests/fuzz/campaign.py).",
            .arguments = {},
            .plots = {}};
}

}  // namespace

std::vector<ReportSection> sections_made_elsewhere()
{
    return {game_map_section(), devices_section(), fuzz_section()};
}

}  // namespace hw

// Compiled levels, changed and signed anew: the input is patches.
#include "tests/fuzz/target.hpp"
#include "tests/io/compiled/rooms.hpp"

void hw::fuzz::try_bytes(std::string_view bytes)
{
    static const test::Rooms rooms(1);
    static const std::vector<std::byte> good = rooms.bytes();
    static const test::Signature signature(good);
    const std::string text = patched({reinterpret_cast<const char*>(good.data()), good.size()}, bytes);
    const auto changed = std::as_bytes(std::span(text));
    std::vector<std::byte> file(changed.begin(), changed.end());
    signature.renew(file);
    const CompiledLevel level = rooms.read(file);
    for (double x = -9.5; x < 12.0; x += 1.5) {
        for (const double z : {-4.0, 0.0, 4.0}) {
            test::seen_from(level.visibility, {x, 0, z});
            visible_leaf_count(level.visibility, {x, 0, z}, 0.1);
        }
    }
}

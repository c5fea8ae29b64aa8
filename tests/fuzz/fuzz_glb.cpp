// Binary glTF files as they are.
#include "tests/fuzz/target.hpp"

void hw::fuzz::try_bytes(std::string_view bytes)
{
    use_gltf(bytes);
}

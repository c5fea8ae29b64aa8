// glTF documents: JSON, and after a zero byte what its binary chunk holds, in a container without a fault.
#include "tests/fuzz/target.hpp"
#include "tests/io/gltf/model_builder.hpp"

void hw::fuzz::try_bytes(std::string_view bytes)
{
    const std::size_t end = bytes.find('\0');
    if (end == std::string_view::npos) return use_gltf(bytes);
    use_gltf(ModelBuilder::container(std::string(bytes.substr(0, end)), std::string(bytes.substr(end + 1))));
}

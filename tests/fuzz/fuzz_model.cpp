// Models: any bytes must import or be refused by hw::Error.

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <string>

#include "hatchway/core/error.hpp"
#include "hatchway/core/log.hpp"
#include "hatchway/io/gltf/import.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const int file = ::memfd_create("model", 0);
    hw::set_log_level(hw::LogLevel::off);
    if (::ftruncate(file, 0) != 0 || ::pwrite(file, data, size, 0) != static_cast<ssize_t>(size)) std::abort();
    try {
        hw::import_gltf("/proc/self/fd/" + std::to_string(file), "/proc/self/fd");
    } catch (const hw::Error&) {
    }
    return 0;
}

// OBJ, PLY, STL and OFF: any bytes as if they were each of them. What one of them takes is taken.
#include "hatchway/core/error.hpp"
#include "hatchway/io/meshes/import.hpp"
#include "tests/fuzz/target.hpp"

void hw::fuzz::try_bytes(std::string_view bytes)
{
    int refusals = 0;
    for (const MeshFormat format : {MeshFormat::obj, MeshFormat::ply, MeshFormat::stl, MeshFormat::off}) {
        try {
            use_model(import_mesh(format, std::string(bytes), "fuzz", "/proc/self/fd"));
        } catch (const Error& error) {
            require(exit_code(error) == 2);
            if (++refusals == 4) throw;
        }
    }
}

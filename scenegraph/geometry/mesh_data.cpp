#include "hatchway/geometry/mesh_data.hpp"

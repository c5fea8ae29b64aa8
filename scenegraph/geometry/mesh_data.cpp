#include "geometry/mesh_data.hpp"

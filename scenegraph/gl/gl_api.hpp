#pragma once

// The only place that names the loader. Before EGL's headers: libepoxy refuses the other order.
#include <epoxy/gl.h>

#include "hatchway/gl/gpu_queries.hpp"

#include "hatchway/gl/gl_api.hpp"

namespace hw {

GpuQueries::~GpuQueries()
{
    if (!ids_.empty()) glDeleteQueries(static_cast<GLsizei>(ids_.size()), ids_.data());
}

void GpuQueries::begin(std::size_t index)
{
    while (ids_.size() <= index) {
        GLuint id = 0;
        glGenQueries(1, &id);
        ids_.push_back(id);
    }
    glBeginQuery(GL_ANY_SAMPLES_PASSED, ids_[index]);
}

void GpuQueries::end()
{
    glEndQuery(GL_ANY_SAMPLES_PASSED);
}

bool GpuQueries::has_passed(std::size_t index) const
{
    GLuint passed = 0;
    glGetQueryObjectuiv(ids_[index], GL_QUERY_RESULT, &passed);
    return passed != 0;
}

}  // namespace hw

// A race that the thread sanitizer has to find, else it finds none of ours.
#include <tbb/parallel_for.h>

#include <cstddef>

int main()
{
    int written_by_all = 0;
    tbb::parallel_for(std::size_t{0}, std::size_t{1000}, [&](std::size_t i) { written_by_all = static_cast<int>(i); });
    return written_by_all > 0 ? 0 : 1;
}

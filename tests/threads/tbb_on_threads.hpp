#pragma once

#include <algorithm>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

/// What the engine uses of TBB, on std::thread alone, for the thread sanitizer. TBB's library is not built with it: who
/// waits for whom inside is not seen there, so it takes all that is handed over for a race, and a suppression of TBB's
/// frames would hide our own races, since our bodies run below them. Here each call starts threads that take one piece
/// after the other, and the sanitizer sees starts, ends and locks. Calls from within a body run on its own thread.
namespace tbb {

namespace on_threads {

inline constexpr std::size_t kThreads = 4;
inline thread_local bool is_worker = false;

/// Calls body(i) for each i below `count`, the threads taking turns, so that each has work. Throws what a body threw
/// first.
template <typename Body>
void run(std::size_t count, const Body& body)
{
    if (is_worker || count < 2) {
        for (std::size_t i = 0; i < count; ++i) body(i);
        return;
    }
    std::exception_ptr thrown;
    std::mutex is_throwing;
    const auto work = [&](std::size_t first) {
        is_worker = true;
        try {
            for (std::size_t i = first; i < count; i += kThreads) body(i);
        } catch (...) {
            const std::lock_guard lock(is_throwing);
            if (!thrown) thrown = std::current_exception();
        }
    };
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < std::min(kThreads, count); ++i) threads.emplace_back(work, i);
    for (std::thread& thread : threads) thread.join();
    if (thrown) std::rethrow_exception(thrown);
}

}  // namespace on_threads

template <typename Value>
class blocked_range {
 public:
    blocked_range(Value begin, Value end, std::size_t /*grain*/ = 1) : begin_(begin), end_(end) {}
    Value begin() const { return begin_; }
    Value end() const { return end_; }

 private:
    Value begin_;
    Value end_;
};

namespace on_threads {

/// The range in pieces, several for each thread.
template <typename Value>
std::vector<blocked_range<Value>> pieces_of(const blocked_range<Value>& range)
{
    const Value length = std::max<Value>(1, (range.end() - range.begin()) / (4 * kThreads));
    std::vector<blocked_range<Value>> pieces;
    for (Value begin = range.begin(); begin < range.end(); begin += std::min<Value>(length, range.end() - begin))
        pieces.emplace_back(begin, begin + std::min<Value>(length, range.end() - begin));
    return pieces;
}

}  // namespace on_threads

template <typename Value, typename Body>
void parallel_for(const blocked_range<Value>& range, const Body& body)
{
    const auto pieces = on_threads::pieces_of(range);
    on_threads::run(pieces.size(), [&](std::size_t i) { body(pieces[i]); });
}

template <typename Index, typename Body>
void parallel_for(Index begin, Index end, const Body& body)
{
    parallel_for(blocked_range<Index>(begin, end), [&](const blocked_range<Index>& range) {
        for (Index i = range.begin(); i < range.end(); ++i) body(i);
    });
}

template <typename Iterator, typename Body>
void parallel_for_each(Iterator begin, Iterator end, const Body& body)
{
    std::vector<Iterator> places;
    for (; begin != end; ++begin) places.push_back(begin);
    on_threads::run(places.size(), [&](std::size_t i) { body(*places[i]); });
}

template <typename Value, typename Sum, typename Body, typename Join>
Sum parallel_reduce(const blocked_range<Value>& range, const Sum& identity, const Body& body, const Join& join)
{
    const auto pieces = on_threads::pieces_of(range);
    std::vector<Sum> sums(pieces.size(), identity);
    on_threads::run(pieces.size(), [&](std::size_t i) { sums[i] = body(pieces[i], identity); });
    Sum sum = identity;
    for (const Sum& each : sums) sum = join(sum, each);
    return sum;
}

template <typename First, typename Second>
void parallel_invoke(const First& first, const Second& second)
{
    on_threads::run(2, [&](std::size_t i) { i == 0 ? first() : second(); });
}

/// Sorts two halves at once.
template <typename Iterator, typename... Before>
void parallel_sort(Iterator begin, Iterator end, const Before&... is_before)
{
    const Iterator middle = begin + (end - begin) / 2;
    parallel_invoke([&] { std::sort(begin, middle, is_before...); }, [&] { std::sort(middle, end, is_before...); });
    std::inplace_merge(begin, middle, end, is_before...);
}

template <typename Value>
class enumerable_thread_specific {
 public:
    Value& local()
    {
        const std::lock_guard lock(is_used_);
        return values_[std::this_thread::get_id()];
    }
    auto begin() { return Each{values_.begin()}; }
    auto end() { return Each{values_.end()}; }

 private:
    struct Each {
        typename std::map<std::thread::id, Value>::iterator at;
        Value& operator*() const { return at->second; }
        Each& operator++()
        {
            ++at;
            return *this;
        }
        bool operator!=(const Each& other) const { return at != other.at; }
    };
    std::mutex is_used_;
    std::map<std::thread::id, Value> values_;
};

struct task_arena {
    static constexpr int automatic = -1;
    explicit task_arena(int = automatic) {}
    template <typename Body>
    auto execute(const Body& body)
    {
        return body();
    }
};

/// Takes no effect: there are always as many threads.
struct global_control {
    enum parameter { max_allowed_parallelism };
    global_control(parameter, std::size_t) {}
};

}  // namespace tbb

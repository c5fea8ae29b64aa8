// A small fuzzer for compilers without libFuzzer: changes known files at random, always in the same order.
//   fuzz_glb SECONDS FILE...   tries the files, then changes them for so long; what is tried lies in fuzz_glb.input
//   fuzz_glb FILE              tries one input as it is, and says what became of it
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "tests/fuzz/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;
using Random = std::mt19937_64;

constexpr std::uint64_t kSeed = 20011;
constexpr std::size_t kLongestSeed = 1 << 16;
constexpr std::size_t kLongestInput = 1 << 18;

std::string read(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
}

/// Files and all that lies below folders, without what is too long to be changed often.
std::vector<std::string> seeds_of(const std::vector<std::string>& places)
{
    std::vector<fs::path> files;
    for (const fs::path place : places) {
        if (!fs::is_directory(place)) files.push_back(place);
        if (fs::is_directory(place))
            for (const auto& entry : fs::recursive_directory_iterator(place))
                if (entry.is_regular_file()) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    std::vector<std::string> seeds{""};
    for (const fs::path& file : files)
        if (fs::file_size(file) <= kLongestSeed) seeds.push_back(read(file));
    return seeds;
}

std::size_t below(std::size_t limit, Random& random)
{
    return limit == 0 ? 0 : random() % limit;
}

void change(std::string& input, const std::vector<std::string>& seeds, Random& random)
{
    const std::size_t at = below(input.size() + 1, random);
    const std::size_t length = below(std::min<std::size_t>(input.size() - at, 64) + 1, random);
    const std::string& other = seeds[below(seeds.size(), random)];
    const std::size_t from = below(other.size() + 1, random);
    static const char* const numbers[] = {"-1", "0", "4294967295", "1e308", "-0.0", "null", "2147483648", "0.5"};
    switch (random() % 8) {
        case 0:
            if (at < input.size()) input[at] = static_cast<char>(input[at] ^ (1 << random() % 8));
            break;
        case 1:
            if (at < input.size()) input[at] = static_cast<char>(random());
            break;
        case 2:
            input.erase(at, length);
            break;
        case 3:
            input.insert(at, input.substr(at, length));
            break;
        case 4:
            input.insert(at, numbers[random() % std::size(numbers)]);
            break;
        case 5:
            input.replace(at, length, other.substr(from, random() % 256));
            break;
        case 6:
            for (std::size_t i = at; i < at + std::min<std::size_t>(4, input.size() - at); ++i)
                input[i] = random() % 2 ? '\xff' : '\0';
            break;
        default:
            input.resize(at);
    }
    if (input.size() > kLongestInput) input.resize(kLongestInput);
}

std::string changed(const std::vector<std::string>& seeds, Random& random)
{
    std::string input = seeds[below(seeds.size(), random)];
    for (std::size_t changes = 1 + random() % 8; changes > 0; --changes) change(input, seeds, random);
    return input;
}

void run(const std::string& input)
{
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc < 2) return 2;
    if (argc == 2) {
        run(read(argv[1]));
        std::cout << (hw::fuzz::taken > 0 ? "taken" : hw::fuzz::refusal) << '\n';
        return 0;
    }
    const std::chrono::duration<double> limit(std::atof(argv[1]));
    const std::vector<std::string> seeds = seeds_of({argv + 2, argv + argc});
    const fs::path kept = fs::path(argv[0]).filename().string() + ".input";
    const auto try_kept = [&](const std::string& input) {
        std::ofstream(kept, std::ios::binary) << input;
        run(input);
    };
    for (const std::string& seed : seeds) try_kept(seed);
    const std::uint64_t good_seeds = hw::fuzz::taken;
    const auto start = std::chrono::steady_clock::now();
    Random random(kSeed);
    std::uint64_t inputs = 0;
    for (; std::chrono::steady_clock::now() - start < limit; ++inputs) try_kept(changed(seeds, random));
    fs::remove(kept);
    std::cout << inputs << " inputs, " << hw::fuzz::taken - good_seeds << " taken, from " << seeds.size() << " seeds, "
              << good_seeds << " taken\n";
    return good_seeds > 0 ? 0 : 1;  // what no seed gets past is not tried
}

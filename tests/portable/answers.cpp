// Answers every family of pairs and of moving pairs, and prints a line for each: its name and a hash of the bits of all
// answers. Programs for different processors print the same lines.
//   answers write FILE PAIRS          also writes the pairs of the families that search with exact arithmetic into FILE
//   answers read FILE PAIRS           reads those from FILE: a build without GMP
//   answers read FILE PAIRS FAMILY    prints the bits of each answer of one family
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <vector>

#include "reference/families/cast_families.hpp"
#include "reference/families/family_lists.hpp"
#include "tumble/distance.hpp"

namespace {

using namespace tumble;
using Bits = std::vector<std::uint64_t>;

void add(Bits& bits, double number) { bits.push_back(std::bit_cast<std::uint64_t>(number)); }

void add(Bits& bits, const DVec2& v) {
    add(bits, v.x);
    add(bits, v.y);
}

Bits bits_of(const DistanceResult& result) {
    Bits bits{static_cast<std::uint64_t>(result.status)};
    if (result.status == DistanceStatus::invalid) return bits;  // its numbers may be NaN, which has many bit patterns
    for (const double number : {result.distance, result.lower, result.upper}) add(bits, number);
    for (const DVec2& v : {result.point_a, result.point_b, result.normal}) add(bits, v);
    bits.push_back(result.iterations);
    return bits;
}

Bits bits_of(const CastResult& result) {
    Bits bits{static_cast<std::uint64_t>(result.status), static_cast<std::uint64_t>(result.iterations)};
    for (const double number : {result.fraction, result.lower, result.upper}) add(bits, number);
    if (result.status != CastStatus::hit) return bits;
    add(bits, result.point);
    add(bits, result.normal);
    return bits;
}

// A file of plain values.
class File {
public:
    File(const char* path, const char* mode) : file_(std::fopen(path, mode)) {
        if (file_ == nullptr) throw std::runtime_error(std::string("cannot open ") + path);
    }
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File() { std::fclose(file_); }

    template <typename T>
    void write(const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        if (std::fwrite(&value, sizeof value, 1, file_) != 1) throw std::runtime_error("cannot write");
    }
    template <typename T>
    T read() {
        static_assert(std::is_trivially_copyable_v<T>);
        T value;
        if (std::fread(&value, sizeof value, 1, file_) != 1) throw std::runtime_error("the file of pairs is too short");
        return value;
    }

private:
    std::FILE* file_;
};

void write(File& file, const Shape& shape) {
    file.write(shape.vertex_count());
    for (int i = 0; i < shape.vertex_count(); ++i) file.write(shape.vertex(i));
    file.write(shape.radius());
}

Shape read_shape(File& file) {
    std::vector<Vec2> vertices(static_cast<std::size_t>(file.read<int>()));
    for (Vec2& v : vertices) v = file.read<Vec2>();
    return Shape::from_raw(vertices, file.read<float>());
}

void write(File& file, const reference::PairQuery& query) {
    write(file, query.a);
    write(file, query.b);
    file.write(query.pose_a);
    file.write(query.pose_b);
}

reference::PairQuery read_query(File& file) {
    reference::PairQuery query;
    query.a = read_shape(file);
    query.b = read_shape(file);
    query.pose_a = file.read<Pose>();
    query.pose_b = file.read<Pose>();
    return query;
}

class Printer {
public:
    Printer(std::uint64_t pairs, std::string_view one_family) : pairs_(pairs), one_family_(one_family) {}

    // answer(i) gives the bits of answer i.
    void print(std::string_view kind, std::string_view name, const std::function<Bits(std::uint64_t)>& answer) const {
        std::uint64_t hash = 0;
        for (std::uint64_t i = 0; i < pairs_; ++i) {
            const Bits bits = answer(i);
            for (const std::uint64_t number : bits) hash = mixed(hash, number);
            if (name == one_family_) print_answer(i, bits);
        }
        if (!one_family_.empty()) return;
        std::printf("%s %s %016llx\n", std::string(kind).c_str(), std::string(name).c_str(),
                    static_cast<unsigned long long>(hash));
    }
    std::uint64_t pairs() const { return pairs_; }

private:
    // Every bit of both has an effect on every bit that follows, as the finaliser of splitmix64 states.
    static std::uint64_t mixed(std::uint64_t hash, std::uint64_t number) {
        std::uint64_t z = (hash ^ number) + 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    static void print_answer(std::uint64_t index, const Bits& bits) {
        std::printf("%llu", static_cast<unsigned long long>(index));
        for (const std::uint64_t number : bits) std::printf(" %016llx", static_cast<unsigned long long>(number));
        std::printf("\n");
    }

    std::uint64_t pairs_;
    std::string_view one_family_;
};

Bits answer(const reference::PairQuery& query) {
    return bits_of(distance(query.a, query.pose_a, query.b, query.pose_b));
}

constexpr std::string_view kSearched[] = {"trajectory", "most_iterations", "largest_error"};

void print_searched(const Printer& printer, bool is_writing, const char* path) {
    File file(path, is_writing ? "wb" : "rb");
    for (const std::string_view name : kSearched) {
        const reference::PairFamily* const family = is_writing ? reference::find_pair_family(name) : nullptr;
        if (is_writing && family == nullptr) throw std::runtime_error("this build cannot search for pairs");
        printer.print("distance", name, [&](std::uint64_t i) {
            if (family == nullptr) return answer(read_query(file));
            const reference::PairQuery query = family->generate(1, i);
            write(file, query);
            return answer(query);
        });
    }
}

bool is_searched(std::string_view name) {
    for (const std::string_view searched : kSearched)
        if (name == searched) return true;
    return false;
}

void print_all(const Printer& printer, bool is_writing, const char* path) {
    for (const reference::PairFamily& family : reference::pair_families())
        if (!is_searched(family.name))
            printer.print("distance", family.name, [&](std::uint64_t i) { return answer(family.generate(1, i)); });
    print_searched(printer, is_writing, path);
    for (const reference::CastFamily& family : reference::cast_families())
        printer.print("cast", family.name,
                      [&](std::uint64_t i) { return bits_of(query_tumble(family.generate(1, i))); });
}

}  // namespace

int main(int argument_count, char** arguments) try {
    const std::string_view mode = argument_count >= 4 ? arguments[1] : "";
    if (mode != "write" && mode != "read") throw std::runtime_error("usage: answers write|read FILE PAIRS [FAMILY]");
    const Printer printer(std::strtoull(arguments[3], nullptr, 10), argument_count > 4 ? arguments[4] : "");
    print_all(printer, mode == "write", arguments[2]);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "answers: %s\n", error.what());
    return 1;
}

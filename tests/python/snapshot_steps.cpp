// For test_scene.py: snapshot_steps FILE STEPS prints the state hash of the world of a snapshot, makes steps, prints
// the hash again and saves the world to the file.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <span>
#include <string>

#include "tumble/world.hpp"

int main(int count, char** arguments) {
    if (count != 3) return EXIT_FAILURE;
    std::ifstream in(arguments[1], std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    tumble::World world = tumble::World::load(std::as_bytes(std::span(bytes)));
    std::printf("%016llx\n", static_cast<unsigned long long>(world.state_hash()));
    for (int i = std::atoi(arguments[2]); i > 0; --i) world.step();
    std::printf("%016llx\n", static_cast<unsigned long long>(world.state_hash()));
    const std::vector<std::byte> saved = world.save();
    std::ofstream out(arguments[1], std::ios::binary);
    out.write(reinterpret_cast<const char*>(saved.data()), static_cast<std::streamsize>(saved.size()));
}

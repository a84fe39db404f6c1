// The plan of a sweep: which scenes, with which parameters and seeds, how many runs, and what each run writes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/scene_file.hpp"

namespace tumble::sweep {

// Where the numbers of drawn parameters come from: independent, one in each of `slices` equal slices of every parameter
// (McKay, Beckman, Conover 1979), or the points of a Sobol sequence (Joe, Kuo 2008).
enum class Sampling { random, latin_hypercube, sobol };

struct Parameter {
    enum class Kind { list, range, log_range, normal, choice };

    std::string name;                   // a column of the table, and a name in expressions
    std::vector<std::string> pointers;  // of the scene, as in --set; each gets the value
    Kind kind = Kind::list;
    std::vector<std::string> values{};  // JSON texts, of `list` and `choice`
    double lower = 0.0, upper = 0.0;    // of ranges; of `normal` the mean and the deviation
    std::uint64_t count = 0;            // of ranges: values on the grid; 0: drawn
    bool whole = false;                 // of ranges: whole numbers

    bool is_on_grid() const { return kind == Kind::list || count > 0; }
    std::uint64_t grid_size() const { return kind == Kind::list ? values.size() : count; }
};

// A number that is measured at the end of each run.
struct Measure {
    std::string name;
    std::string expression;
};

struct Filter {
    bool claims = false;  // keep only runs whose claims hold
    std::string that{};   // keep only runs for which this condition holds at the end; empty: all
};

// Pictures of a run in the tar file, of the state at the start, and after every `every` steps: a PNG file each, or all
// as one MP4.
struct Pictures {
    std::uint64_t every = 0;  // steps; 0: none
    int width = 256, height = 256;
    bool is_plain = false;  // of frames: without grid, scale bar and text
    bool is_video = false;  // of frames: as MP4

    bool are_due(std::uint64_t step) const { return every > 0 && step % every == 0; }
};

struct Written {
    std::uint64_t trajectory_every = 0;  // steps; 0: no trajectory
    bool trajectory_in_tar = false;      // as .npy in the tar file; else in the HDF5 file
    int trajectory_bits = 32;            // of a number: 32 or 64
    bool events = false, contacts = false, final_state = false, summary = false;
    Pictures frames{}, masks{};

    bool has_frames() const { return frames.every > 0; }
    bool has_pictures() const { return has_frames() || masks.every > 0; }
    bool has_tar() const {
        return events || contacts || final_state || summary || has_pictures() ||
               (has_trajectory() && trajectory_in_tar);
    }
    bool has_hdf5() const { return has_trajectory() && !trajectory_in_tar; }
    bool has_trajectory() const { return trajectory_every > 0; }
};

// The seeds of the worlds: one drawn for each run, or given ones, which are a dimension of the grid.
struct Seeds {
    bool is_drawn = true;
    std::vector<std::uint64_t> list{};
    std::uint64_t first = 0, count = 0;  // if the list is empty

    std::uint64_t grid_size() const { return is_drawn ? 1 : list.empty() ? count : list.size(); }
};

inline constexpr std::uint64_t kMostRuns = std::uint64_t{1} << 53;
inline constexpr std::uint64_t kMostShardRuns = 1000000;

struct Plan {
    std::string name, description;
    std::filesystem::path file;                 // of the plan, or a name for its text in errors
    std::string text;                           // of the file
    std::vector<std::filesystem::path> scenes;  // as the plan names them, relative to its folder
    std::vector<std::string> settings;          // "/pointer=value", the same for all runs
    std::uint64_t runs = 0;
    bool states_runs = false;  // the file or the option --runs; else each point of the grid has one
    std::uint64_t slices = 0;  // of a Latin hypercube: the runs that the file states
    std::uint64_t seed = 1;
    Seeds seeds;
    Sampling sampling = Sampling::random;
    std::vector<Parameter> parameters;
    std::vector<Measure> measures;
    Filter filter;
    Written write;
    std::uint64_t shard_runs = 0;  // 0: chosen by runs_in_shard()
    bool allow_outside = false;    // of the option, not of the file: as LoadOptions::allow_outside
    double timeout = 0.0;          // s of wall clock for a run; 0: none
    std::uint64_t hash = 0;        // of the texts of the plan and of its scenes with all that they include
};

// The path of a scene of the plan.
std::filesystem::path scene_file(const Plan& plan, std::size_t scene);

// Combinations of scenes, seeds and values on the grid.
std::uint64_t grid_size(const Plan& plan);

// The runs of a shard: those of the plan, else as many as make 60 shards, at most 2000. Sixty shards are at most
// 180 files at a time: a tar file, an HDF5 file, and the lines of the table.
std::uint64_t runs_in_shard(const Plan& plan);
std::uint64_t shard_count(const Plan& plan);

// What one run simulates.
struct RunChoice {
    std::uint64_t run = 0;
    std::size_t scene = 0;            // index into Plan::scenes
    std::uint64_t seed = 0;           // of the world
    std::vector<std::string> values;  // JSON texts, by parameter
};

// Depends on the plan and the number of the run alone, in constant time. The bits are the same on every machine.
RunChoice choose_run(const Plan& plan, std::uint64_t run);

// The changes of the scene that a run makes, as --set takes them.
std::vector<std::string> overrides_of(const Plan& plan, const RunChoice& choice);

// Reads a plan with its scenes, and tries its first run. `runs` replaces those of the plan if it is not 0. The scenes
// and what they include are in the folder of the plan, or `allow_outside` accepts others. Throws FileError, or
// SceneError with line and column for a plan that is not valid or does not fit its scenes. Warnings are appended to
// `warnings` if it is not null.
Plan read_plan(const std::filesystem::path& file, std::uint64_t runs = 0, bool allow_outside = false,
               std::vector<Diagnostic>* warnings = nullptr);

// The same from a text. `file` is its name in errors; its scenes are relative to the folder of `file`.
Plan parse_plan(std::string text, const std::filesystem::path& file, std::uint64_t runs = 0, bool allow_outside = false,
                std::vector<Diagnostic>* warnings = nullptr);

// The JSON schema (Draft-07) of plans.
std::string plan_schema();

}  // namespace tumble::sweep

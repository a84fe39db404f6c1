// Colours of contacts: no two contacts of a colour share a dynamic body, so that solving eight of them side by side in
// lanes gives the same result as one after the other.
//
// The colouring is greedy in the order of contacts. It depends only on the solved contacts and their bodies. It is
// kept, with the regions, until one of them or the least size of a region changes. A contact between dynamic bodies
// skips 0 to 3 free colours, a number that it draws when it begins. Without it the order of solving follows the order
// of the shapes: a pass carries impulses through a pile in one direction only, and large piles take up to twice as long
// to fall asleep.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "debug/check.hpp"
#include "dynamics/bodies/body_store.hpp"
#include "dynamics/bodies/constants.hpp"
#include "dynamics/contacts/contact.hpp"
#include "dynamics/contacts/regions.hpp"
#include "simd/lane_count.hpp"
#include "tasks/crew.hpp"

namespace tumble {

class ConstraintGraph {
public:
    static constexpr std::uint32_t kNoContact = 0xffffffffu;  // in an unused lane

    // The solver bodies have parts: the regions, or if there is one region of many bodies, this number of them. The
    // contacts of a colour are in the order of the parts: a thread works on a part of each colour and of the bodies,
    // and threads then share few bodies. On two threads, a step of smash takes 4 % less.
    static constexpr std::uint32_t kParts = 16;

    // Groups the contacts that are solved into blocks of kLaneCount lanes: those with points that do not bounce.
    // Divides the bodies into regions of at least `least_region` bodies.
    void build(std::span<const Contact> contacts, const BodyStore& bodies, Crew& crew,
               std::uint32_t least_region = kOneRegion);

    std::size_t block_count() const { return lanes_.size() / kLaneCount; }
    int color_count() const;  // that any contact has

    // The contacts of a block, by lane: indices or kNoContact. The blocks of a region are in the order of solving:
    // contacts without a colour, contacts between dynamic bodies, contacts with a static or kinematic body.
    std::span<const std::uint32_t, kLaneCount> block(std::size_t index) const {
        TUMBLE_CHECK(index < block_count());
        return std::span<const std::uint32_t, kLaneCount>(lanes_.data() + index * kLaneCount, kLaneCount);
    }

    // The blocks of a colour: solved at the same time, they give the same result as one after the other. Contacts
    // without a colour depend on each other.
    struct Color {
        std::size_t begin = 0;
        std::size_t end = 0;
        bool is_independent = true;
    };
    // A range of the solver bodies, and of the colours of its contacts.
    struct Region {
        BodyRange bodies;
        std::size_t first_color = 0;
        std::size_t end_color = 0;
        std::size_t work = 0;  // a measure of the time to solve it
    };
    // They cover all bodies but the static one, and all colours.
    std::span<const Region> regions() const { return regions_; }

    // True if so many threads, each with a region of its own at a time, take little longer than with equal shares of
    // the work: no region is more than one and a half shares.
    bool has_even_regions(std::size_t threads) const;

    // In the order of solving: the contacts without a colour, then the colours that have contacts.
    std::span<const Color> colors(const Region& region) const {
        return std::span(colors_).subspan(region.first_color, region.end_color - region.first_color);
    }

    // True if the blocks contain a contact of the dynamic solver body.
    bool has_contact(std::uint32_t solver_body) const {
        TUMBLE_CHECK(solver_body < used_colors_.size());
        return used_colors_[solver_body] != 0;
    }

    // Throws std::logic_error if the lanes are not those of the solved contacts, or if the regions do not follow one
    // another.
    void audit() const;

    std::size_t bytes() const {
        return candidates_.capacity() * sizeof(Candidate) + movers_.capacity() * sizeof(Mover) +
               (used_colors_.capacity() + solved_.capacity()) * sizeof(std::uint32_t) +
               (bounds_.capacity() + farthest_.capacity() + region_of_.capacity() + groups_.capacity() +
                ends_.capacity() + lanes_.capacity()) *
                   sizeof(std::uint32_t) +
               colors_.capacity() * sizeof(Color) + regions_.capacity() * sizeof(Region);
    }

private:
    static constexpr int kColors = kDynamicColors + kStaticColors;
    static constexpr std::uint8_t kNoColor = kColors;
    // The input of the colouring: one Candidate for each contact, one Mover for each solver body.
    struct Candidate {
        std::uint32_t body_a = 0;  // index
        std::uint32_t body_b = 0;
        std::uint32_t skipped_colors = kNotSolved;

        static constexpr std::uint32_t kNotSolved = 0xffffffffu;
        bool is_solved() const { return skipped_colors != kNotSolved; }
        // Branch-free: where contacts change often, the processor mispredicts a branch for each member.
        friend bool operator!=(const Candidate& x, const Candidate& y) {
            return ((x.body_a ^ y.body_a) | (x.body_b ^ y.body_b) | (x.skipped_colors ^ y.skipped_colors)) != 0;
        }
    };
    struct Mover {
        std::uint32_t body = 0;  // index
        bool is_dynamic = false;

        friend bool operator==(const Mover&, const Mover&) = default;
    };

    // Each returns true if something has changed since the last call.
    bool update_candidates(std::span<const Contact> contacts, Crew& crew);
    bool update_movers(const BodyStore& bodies);

    void find_solved();
    void color(const BodyStore& bodies);
    static std::uint32_t dynamic_body(const Candidate& contact, const BodyStore& bodies);
    void connect(const Candidate& contact, const BodyStore& bodies);
    void group_by_region(const BodyStore& bodies);
    void add_region(std::uint32_t index);
    void fill_lanes();
    std::uint8_t choose_color(const Candidate& contact, const BodyStore& bodies);

    std::vector<Candidate> candidates_;       // by contact
    std::vector<Mover> movers_;               // by solver body
    std::vector<std::uint32_t> used_colors_;  // by solver body, a bit for each colour, and for kNoColor
    std::vector<std::uint32_t> solved_;       // the contacts that are solved: indices
    std::vector<std::uint32_t> bounds_;       // of the regions: see find_regions()
    std::vector<std::uint32_t> farthest_;     // by solver body: see find_regions()
    std::vector<std::uint32_t> region_of_;    // by solver body, if there are several
    std::vector<std::uint32_t> groups_;       // by position in solved_: colour * part_count_ + part
    std::vector<std::uint32_t> ends_;         // by group: the number of contacts, then where the next lane is
    std::vector<std::uint32_t> lanes_;        // index of a contact, or kNoContact
    std::vector<Color> colors_;               // region by region
    std::vector<Region> regions_;
    std::uint32_t least_region_ = kOneRegion;
    std::uint32_t part_count_ = 1;
    bool is_complete_ = false;  // false before the first build(), and after an exception
};

}  // namespace tumble

// Sprites of the exported samples from views of all kinds, with the hashes that core's caster
// gives: what the other runtimes are held against.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/bytes.h"

namespace voxprite::test {

struct SpriteJob {
    std::uint32_t model = 0;         // of the entity
    std::uint32_t entity = 0;        // of the file
    nlohmann::json shot;             // as `render --json` prints it: lattice and lit
    bool narrow = true;              // fits 31 bits
    std::string size, colours, ids;  // "130x191" and two hashes
};

struct JobSet {
    std::string name;
    Bytes svo;
    std::vector<SpriteJob> jobs;
};

// Each sample from 20 views at three sigmas and more, frames in turn; a model too large for 31
// bits; and a file of all samples, each from a few views.
[[nodiscard]] std::vector<JobSet> spriteJobs();
// The shot of one of them.
[[nodiscard]] nlohmann::json oneShot();

}  // namespace voxprite::test

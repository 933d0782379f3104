#include "app/editor/views/scene_copies.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "core/sprite/camera.h"
#include "core/svo/octree.h"

namespace voxprite::editor {
namespace {

// Free room around everyone, as a share of what they reach.
constexpr double kAir = 1.1;
constexpr double kGoldenAngle = 2.399963229728653;

// A hash as a random number in [0, 1): the same for the same copy, however many others there are.
double randomShare(int seed, std::uint64_t number, std::uint64_t what) {
    std::uint64_t x = static_cast<std::uint64_t>(seed) * 0x9E37'79B9'7F4A'7C15u + number;
    x = (x ^ (what << 56)) + 0x9E37'79B9'7F4A'7C15u;
    x = (x ^ (x >> 30)) * 0xBF58'476D'1CE4'E5B9u;
    x = (x ^ (x >> 27)) * 0x94D0'49BB'1331'11EBu;
    x ^= x >> 31;
    return static_cast<double>(x >> 11) * 0x1p-53;
}
enum What : std::uint64_t { kSubject, kTurn, kJitterAcross, kJitterAhead };

// Circles on the ground, of which none may touch another.
class Crowd {
  public:
    explicit Crowd(double largestRadius) : cell_(2.0 * largestRadius) {}

    void add(glm::dvec2 at, double radius) { cells_[keyOf(at)].push_back({at, radius}); }
    [[nodiscard]] bool hasRoom(glm::dvec2 at, double radius) const {
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                const auto found = cells_.find(keyOf(at + glm::dvec2(dx, dy) * cell_));
                if (found == cells_.end()) continue;
                for (const Circle& other : found->second) {
                    if (glm::length(other.at - at) < other.radius + radius) return false;
                }
            }
        }
        return true;
    }

  private:
    struct Circle {
        glm::dvec2 at;
        double radius;
    };
    [[nodiscard]] std::uint64_t keyOf(glm::dvec2 at) const {
        const auto x = static_cast<std::int32_t>(std::floor(at.x / cell_));
        const auto y = static_cast<std::int32_t>(std::floor(at.y / cell_));
        return static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32 |
               static_cast<std::uint32_t>(y);
    }
    double cell_;
    std::unordered_map<std::uint64_t, std::vector<Circle>> cells_;
};

class Arranger {
  public:
    Arranger(const CopySettings& settings, std::span<const CopySubject> subjects)
        : settings_(settings), subjects_(subjects), most_(roomOf(0)) {
        for (int i = 0; i < static_cast<int>(subjects.size()); ++i) {
            if (!subjects[static_cast<std::size_t>(i)].used) continue;
            used_.push_back(i);
            most_ = std::max(most_, roomOf(i));
        }
    }

    [[nodiscard]] Formation arrange() {
        if (used_.empty()) return {};
        switch (settings_.pattern) {
            case CopyPattern::none:
                return {};
            case CopyPattern::grid:
                grid();
                break;
            case CopyPattern::crowd:
                crowd();
                break;
            case CopyPattern::march:
                march();
                break;
        }
        for (const SceneCopy& copy : made_.copies) {
            made_.radiusMetres =
                std::max(made_.radiusMetres,
                         std::hypot(copy.acrossMetres, copy.aheadMetres) +
                             subjects_[static_cast<std::size_t>(copy.subject)].reachMetres);
        }
        return std::move(made_);
    }

  private:
    // The radius that a subject has to itself.
    [[nodiscard]] double roomOf(int subject) const {
        return std::max(subjects_[static_cast<std::size_t>(subject)].reachMetres, 1e-6) * kAir *
               std::max(settings_.spacing, kLeastSpacing);
    }
    [[nodiscard]] int subjectOf(std::uint64_t number) const {
        const double share = randomShare(settings_.seed, number, kSubject);
        const auto index = static_cast<std::size_t>(share * static_cast<double>(used_.size()));
        return used_[std::min(index, used_.size() - 1)];
    }
    [[nodiscard]] double turnOf(std::uint64_t number) const {
        if (!settings_.turned) return 0.0;
        return 45.0 * std::floor(8.0 * randomShare(settings_.seed, number, kTurn));
    }

    // Square rings around the middle, the innermost first.
    void grid() {
        const double pitch = 2.0 * most_;
        for (int ring = 1; left() > 0; ++ring) {
            for (int ahead = ring; ahead >= -ring; --ahead) {
                const bool edge = std::abs(ahead) == ring;
                for (int across = -ring; across <= ring && left() > 0;
                     across += edge ? 1 : 2 * ring) {
                    const auto number = static_cast<std::uint64_t>(made_.copies.size());
                    made_.copies.push_back(
                        {subjectOf(number), across * pitch, ahead * pitch, turnOf(number)});
                }
            }
        }
    }

    // Each takes the innermost free point of a spiral that fills the plane evenly. What was refused
    // to a subject once is never free for it again, so each walks along the spiral once.
    void crowd() {
        double least = most_;
        for (const int subject : used_) least = std::min(least, roomOf(subject));
        least = std::max(least, 0.25 * most_);  // a finer search would take too long
        Crowd crowd(most_);
        crowd.add(glm::dvec2(0.0), roomOf(0));
        std::vector<std::uint64_t> next(subjects_.size(), 1);
        while (left() > 0) {
            const auto number = static_cast<std::uint64_t>(made_.copies.size());
            const int subject = subjectOf(number);
            std::uint64_t& point = next[static_cast<std::size_t>(subject)];
            while (!crowd.hasRoom(spiral(point, least), roomOf(subject))) ++point;
            const glm::dvec2 at = spiral(point++, least);
            crowd.add(at, roomOf(subject));
            made_.copies.push_back({subject, at.x, at.y, turnOf(number)});
        }
    }
    // Points `room` has space at: neighbours are some 1.7 times the factor apart, less the jitter.
    [[nodiscard]] glm::dvec2 spiral(std::uint64_t point, double room) const {
        const double radius = 1.35 * room * std::sqrt(static_cast<double>(point));
        const double angle = kGoldenAngle * static_cast<double>(point);
        const auto jitter = [&](What what) {
            return (randomShare(settings_.seed, point, what) - 0.5) * 0.5 * room;
        };
        return {radius * std::cos(angle) + jitter(kJitterAcross),
                radius * std::sin(angle) + jitter(kJitterAhead)};
    }

    // Ranks of an even number of files, half of them on each side.
    void march() {
        const double pitch = 2.0 * most_;
        const int half =
            std::max(1, static_cast<int>(std::lround(std::sqrt(settings_.count / 8.0) / 2.0)));
        const int ranks = (settings_.count + 2 * half - 1) / (2 * half);
        made_.loopMetres = ranks * pitch;
        for (int rank = 0; rank < ranks; ++rank) {
            for (int file = 1; file <= half; ++file) {
                for (int side = -1; side <= 1 && left() > 0; side += 2) {
                    const auto number = static_cast<std::uint64_t>(made_.copies.size());
                    made_.copies.push_back({subjectOf(number), side * file * pitch,
                                            (0.5 * (ranks - 1) - rank) * pitch, 0.0});
                }
            }
        }
    }
    [[nodiscard]] int left() const {
        return std::clamp(settings_.count, 0, kMostCopies) - static_cast<int>(made_.copies.size());
    }

    const CopySettings& settings_;
    std::span<const CopySubject> subjects_;
    std::vector<int> used_;
    double most_;  // the largest room
    Formation made_;
};

}  // namespace

Formation arrangeCopies(const CopySettings& settings, std::span<const CopySubject> subjects) {
    if (subjects.empty()) return {};
    return Arranger(settings, subjects).arrange();
}

SceneCopy walked(const SceneCopy& copy, const Formation& formation, double walkedMetres) {
    SceneCopy now = copy;
    if (formation.loopMetres > 0.0) {
        now.aheadMetres = std::remainder(copy.aheadMetres + walkedMetres, formation.loopMetres);
    }
    return now;
}

PlacedEntity standing(const PlacedEntity& subject, const SceneCopy& copy, double facingDegrees) {
    const SinCos facing = sinCosDegrees(facingDegrees);
    const SinCos turn = sinCosDegrees(copy.turnDegrees);
    const glm::dmat3 aboutUp{turn.cos, 0, -turn.sin, 0, 1, 0, turn.sin, 0, turn.cos};
    PlacedEntity placed = subject;
    placed.worldFromVoxelAxes = aboutUp * subject.worldFromVoxelAxes;
    // Voxel space's +X is the world's, its -Y the world's +Z.
    placed.anchorMetres += glm::dvec3(facing.cos, 0.0, -facing.sin) * copy.acrossMetres +
                           glm::dvec3(facing.sin, 0.0, facing.cos) * copy.aheadMetres;
    return placed;
}

double reachMetres(const PlacedEntity& placed) {
    double reach = 0.0;
    for (unsigned octant = 0; octant < 8; ++octant) {
        const glm::dvec3 corner = glm::dvec3(octantCorner(octant) * placed.modelSize);
        const glm::dvec3 from = placed.worldFromVoxel(corner) - placed.anchorMetres;
        reach = std::max(reach, std::hypot(from.x, from.z));
    }
    return reach;
}

}  // namespace voxprite::editor

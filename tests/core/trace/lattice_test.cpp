#include "core/trace/lattice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/trace/lattice_caster.h"
#include "tests/core/trace/dense_model.h"
#include "tests/core/trace/views.h"

namespace voxprite::test {
namespace {

constexpr double kSigmas[] = {1.0 / 64, 0.3, 0.5, 1, 1.5, 2, 3, 4, 7.5, 16};

LatticeView quantised(const OrthoView& view, glm::ivec3 size) {
    const Result<LatticeView> lattice = quantiseView(view, size);
    EXPECT_TRUE(lattice.has_value()) << (lattice ? "" : lattice.error().message);
    return lattice.value_or(LatticeView{});
}

std::string refusal(const OrthoView& view, glm::ivec3 size) {
    const Result<LatticeView> lattice = quantiseView(view, size);
    return lattice ? "accepted" : lattice.error().message;
}

TEST(SampleOffset, KeepsSamplesOffTheFaces) {
    EXPECT_EQ(sampleOffsetPx(1.0), 0.5);
    EXPECT_EQ(sampleOffsetPx(4.0), 0.5);
    EXPECT_EQ(sampleOffsetPx(64.0), 0.5);
    EXPECT_EQ(sampleOffsetPx(0.5), 0.25);  // half a voxel
    EXPECT_EQ(sampleOffsetPx(1.0 / 64), 1.0 / 128);
    EXPECT_EQ(sampleOffsetPx(0.3), 0.15);
    EXPECT_EQ(sampleOffsetPx(1.5), 1.0 / 3.0);
    EXPECT_EQ(sampleOffsetPx(7.5), 1.0 / 3.0);
}

// Seen along an axis, no sample of any sigma lies within three lattice steps of a face.
TEST(QuantiseView, AxisViewsNeverSampleAFace) {
    for (const double sigma : {0.25, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 7.5, 8.0, 16.0, 32.0}) {
        for (const glm::ivec3 size : {glm::ivec3(32), glm::ivec3(31, 16, 17), glm::ivec3(1)}) {
            const LatticeView lattice = quantised(viewAlong({0, 1, 0}, sigma), size);
            const int steps = 1 << lattice.positionBits;
            for (int i = 0; i < lattice.size.x; ++i) {
                const glm::i64vec3 start = rayOf(lattice, lattice.first + glm::ivec2(i, 0)).origin;
                const std::int64_t rest = ((start.x % steps) + steps) % steps;
                EXPECT_GE(std::min(rest, steps - rest), 3) << "sigma " << sigma << " pixel " << i;
            }
        }
    }
}

TEST(QuantiseView, CanonicalViewsHaveSmallIntegerDirections) {
    for (const glm::dvec3& direction : canonicalDirections())
        EXPECT_EQ(quantised(viewAlong(direction, 4), {32, 16, 64}).D, glm::ivec3(direction));
}

TEST(QuantiseView, StaysNearTheViewThatItQuantises) {
    std::mt19937 random(1);
    for (const double sigma : kSigmas) {
        for (const glm::ivec3 size : {glm::ivec3(32, 16, 64), glm::ivec3(7, 7, 7)}) {
            const OrthoView view = randomView(random, sigma);
            const LatticeView lattice = quantised(view, size);
            EXPECT_GE(lattice.positionBits, 8);
            const double steps = std::ldexp(1.0, lattice.positionBits);
            EXPECT_GE(steps / sigma, 16.0);
            // The start of every ray of the buffer, against the real one.
            for (const glm::ivec2 pixel :
                 {lattice.first, lattice.first + lattice.size - 1, glm::ivec2(0)}) {
                const glm::dvec2 px = (glm::dvec2(pixel) + sampleOffsetPx(sigma)) / sigma;
                const glm::dvec3 want = glm::dvec3(size / 2) + px.x * view.right + px.y * view.up;
                const glm::dvec3 start = glm::dvec3(rayOf(lattice, pixel).origin) / steps;
                EXPECT_LT(glm::length(start - want), 2.0 / steps);
            }
            EXPECT_LT(glm::length(glm::cross(glm::normalize(glm::dvec3(lattice.D)), view.forward)),
                      1e-5);
        }
    }
}

TEST(QuantiseView, TheLatticeIsAsFineAs31BitsAllow) {
    const glm::dvec3 forward{1, std::sqrt(5.0), -std::sqrt(1.7)};
    const auto bits = [&](double sigma, int edge) {
        return quantised(viewAlong(forward, sigma), glm::ivec3(edge)).positionBits;
    };
    EXPECT_EQ(bits(4, 16), 12);
    EXPECT_GE(bits(4, 64), 11);
    EXPECT_GE(bits(4, 128), 10);
    EXPECT_GE(bits(4, 256), 9);
    EXPECT_EQ(bits(0.5, 1024), 8);
    EXPECT_EQ(bits(1.0 / 64, 65536), 8);
    EXPECT_GE(bits(64, 30), 10);
}

TEST(QuantiseView, AnAxisViewsBufferIsTheSilhouetteAndOnePixelRound) {
    for (const double sigma : {1.0, 2.0, 3.0, 4.0, 16.0}) {
        const LatticeView lattice = quantised(viewAlong({0, 1, 0}, sigma), {32, 16, 64});
        EXPECT_EQ(lattice.size, glm::ivec2(glm::dvec2(32, 64) * sigma) + 2);
        EXPECT_EQ(lattice.first, -glm::ivec2(glm::dvec2(16, 32) * sigma) - 1);
    }
}

TEST(QuantiseView, NothingOutsideTheBufferIsHit) {
    std::mt19937 random(2);
    for (const glm::ivec3 size : {glm::ivec3(1), glm::ivec3(5, 9, 2), glm::ivec3(16, 16, 16)}) {
        const NaiveOctree tree(solid(size, 1));
        std::vector<OrthoView> views;
        for (const double sigma : kSigmas) {
            if (sigma > 4) continue;
            for (const glm::dvec3& direction : canonicalDirections())
                views.push_back(viewAlong(direction, sigma));
            for (int n = 0; n < 10; ++n) views.push_back(randomView(random, sigma));
        }
        for (const OrthoView& view : views) {
            const LatticeView lattice = quantised(view, size);
            const LatticeCaster caster(tree.view(), lattice);
            const glm::ivec2 end = lattice.first + lattice.size;
            for (int j = lattice.first.y - 2; j < end.y + 2; ++j) {
                for (int i = lattice.first.x - 2; i < end.x + 2; ++i) {
                    const bool inner = i > lattice.first.x && j > lattice.first.y &&
                                       i < end.x - 1 && j < end.y - 1;
                    ASSERT_TRUE(inner || caster.cast({i, j}).material == 0)
                        << "pixel " << i << " " << j << " of a buffer from " << lattice.first.x
                        << " " << lattice.first.y << " to " << end.x << " " << end.y;
                }
            }
        }
    }
}

// Lattices from elsewhere need not be orthogonal, or turned the usual way round.
TEST(PixelBounds, CoverEveryHitOfAnySkewedLattice) {
    std::mt19937 random(3);
    std::uniform_int_distribution<int> component(-10, 10);
    std::uniform_int_distribution<int> step(-300000, 300000);
    const glm::ivec3 size{4, 3, 5};
    const NaiveOctree tree(solid(size, 1));
    int hits = 0;
    for (int n = 0; n < 400; ++n) {
        LatticeView lattice;
        lattice.positionBits = 6;
        lattice.C = glm::ivec3(component(random), component(random), component(random)) * 40;
        lattice.D = {component(random), component(random), component(random)};
        lattice.U = {step(random), step(random), step(random)};
        lattice.V = {step(random), step(random), step(random)};
        const Result<PixelBounds> bounds = pixelBounds(lattice, size);
        if (!bounds) continue;
        const glm::ivec2 end = bounds->first + bounds->size;
        for (int j = -40; j <= 40; ++j) {
            for (int i = -40; i <= 40; ++i) {
                if (castLattice(tree.view(), rayOf(lattice, {i, j})).material == 0) continue;
                ++hits;
                ASSERT_TRUE(i > bounds->first.x && j > bounds->first.y && i < end.x - 1 &&
                            j < end.y - 1)
                    << "pixel " << i << " " << j;
            }
        }
    }
    EXPECT_GT(hits, 5000);
}

TEST(PixelBounds, AreThoseOfQuantisedViews) {
    std::mt19937 random(4);
    for (const double sigma : kSigmas) {
        const glm::ivec3 size{20, 33, 8};
        LatticeView lattice = quantised(randomView(random, sigma), size);
        EXPECT_EQ(*pixelBounds(lattice, size), (PixelBounds{lattice.first, lattice.size}));
        EXPECT_TRUE(validateLattice(lattice, size).has_value());
        ++lattice.size.x;
        EXPECT_FALSE(validateLattice(lattice, size).has_value());
        --lattice.size.x;
        --lattice.first.y;
        EXPECT_FALSE(validateLattice(lattice, size).has_value());
    }
}

TEST(PixelBounds, RefuseLatticesThatCannotBeCast) {
    const glm::ivec3 size(8);
    const LatticeView good = quantised(viewAlong({1, 2, 3}, 4), size);
    const auto message = [&](auto change) {
        LatticeView lattice = good;
        change(lattice);
        const Result<PixelBounds> bounds = pixelBounds(lattice, size);
        return bounds ? std::string("accepted") : bounds.error().message;
    };
    const std::string span = "do not span space";
    EXPECT_NE(message([](auto& l) { l.D = glm::ivec3(0); }).find(span), std::string::npos);
    EXPECT_NE(message([](auto& l) { l.U = l.V; }).find(span), std::string::npos);
    EXPECT_NE(message([](auto& l) { l.D = {8193, 0, 0}; }).find("13 bits"), std::string::npos);
    EXPECT_NE(message([](auto& l) { l.directionBits = 14; }).find("direction bits"),
              std::string::npos);
    EXPECT_NE(message([](auto& l) { l.positionBits = 14; }).find("position bits"),
              std::string::npos);
    EXPECT_NE(message([](auto& l) { l.positionBits = -1; }).find("position bits"),
              std::string::npos);
    EXPECT_NE(message([](auto& l) { l.C.x = std::numeric_limits<int>::min(); }).find("2^28"),
              std::string::npos);
    EXPECT_NE(message([](auto& l) { l.U = l.U / 100000 + 1; }).find("16777216"), std::string::npos);
    EXPECT_NE(message([](auto& l) {
                  l.V = {1, 0, 0};
                  l.U = {0, 1, 0};
              }).find("16777216"),
              std::string::npos);
    // The plane of U and V holds D but for a hair: rays start a long way along it.
    EXPECT_NE(message([](auto& l) {
                  l.D = {8191, 1, 0};
                  l.U = {1 << 28, 34820, 0};
                  l.V = {0, 0, 1 << 24};
              }).find("2^30"),
              std::string::npos);
    EXPECT_EQ(message([](auto&) {}), "accepted");
}

TEST(QuantiseView, AnEmptyModelHasNoPixels) {
    for (const glm::ivec3 size : {glm::ivec3(0), glm::ivec3(0, 5, 5), glm::ivec3(5, 5, 0)})
        EXPECT_EQ(quantised(viewAlong({1, 2, 3}, 4), size).size, glm::ivec2(0));
}

TEST(QuantiseView, TheLimitOfPixelsIsExactAndNamed) {
    // 64 * 64 + 2 pixels an edge are two too many; 63 voxels fit.
    EXPECT_NE(refusal(viewAlong({0, 1, 0}, 64), glm::ivec3(64)).find("16777216"),
              std::string::npos);
    EXPECT_EQ(quantised(viewAlong({0, 1, 0}, 64), glm::ivec3(63)).size, glm::ivec2(63 * 64 + 2));
    EXPECT_NE(refusal(viewAlong({1, 1, 1}, 64), glm::ivec3(65536)).find("16777216"),
              std::string::npos);
    EXPECT_GT(quantised(viewAlong({1, 1, 1}, 1.0 / 64), glm::ivec3(65536)).size.x, 1024);
}

TEST(QuantiseView, RefusesWhatIsNotAView) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    const glm::ivec3 size(8);
    for (const double sigma : {nan, inf, -inf, 0.0, -4.0, 1.0 / 65, 64.001}) {
        OrthoView view;
        view.sigmaInForce = sigma;
        EXPECT_NE(refusal(view, size).find("1/64 ... 64"), std::string::npos) << sigma;
    }
    for (const double bad : {nan, inf, -inf, 0.5, 1e300}) {
        for (glm::dvec3 OrthoView::*axis :
             {&OrthoView::right, &OrthoView::up, &OrthoView::forward}) {
            for (int a = 0; a < 3; ++a) {
                OrthoView view;
                (view.*axis)[a] = bad;
                EXPECT_NE(refusal(view, size).find("orthonormal"), std::string::npos);
            }
        }
    }
    OrthoView flat;
    flat.up = flat.right;
    EXPECT_NE(refusal(flat, size).find("orthonormal"), std::string::npos);
    EXPECT_NE(refusal(OrthoView{}, {-1, 4, 4}).find("65536"), std::string::npos);
    EXPECT_NE(refusal(OrthoView{}, {4, 4, 65537}).find("65536"), std::string::npos);
}

// All products that the 31-bit walk forms, for the rays of the buffer's rim and all faces.
TEST(FitsNarrow, MeansThatProductsFit31Bits) {
    std::mt19937 random(5);
    const double limit = 2147483648.0;
    for (const int edge : {40, 128, 256, 512, 700, 2000}) {
        for (const double sigma : {1.0 / 64, 0.5, 1.0}) {
            const glm::ivec3 size(edge, edge / 2, edge);
            const LatticeView lattice = quantised(randomView(random, sigma), size);
            const double steps = std::ldexp(1.0, lattice.positionBits);
            double largest = 0.0;
            for (const int i : {lattice.first.x, lattice.first.x + lattice.size.x - 1}) {
                for (const int j : {lattice.first.y, lattice.first.y + lattice.size.y - 1}) {
                    for (int a = 0; a < 3; ++a) {
                        const double u = double(i) * lattice.U[a];
                        const double v = double(j) * lattice.V[a];
                        const double o = double(rayOf(lattice, {i, j}).origin[a]);
                        for (const int face : {0, size[a]})
                            for (int b = 0; b < 3; ++b)
                                largest =
                                    std::max(largest, std::abs((face * steps - o) * lattice.D[b]));
                        largest = std::max({largest, std::abs(u), std::abs(v), std::abs(u + v)});
                    }
                }
            }
            if (fitsNarrow(lattice, size)) {
                EXPECT_LT(largest, limit) << edge << " sigma " << sigma;
            } else {
                EXPECT_GT(largest * 1.1, limit) << edge << " sigma " << sigma;
            }
        }
    }
}

TEST(FitsNarrow, HoldsFor128AtEverySigmaAndFor256UpTo16) {
    std::mt19937 random(6);
    const auto check = [&](int edge, double sigma, int views) {
        for (int n = 0; n < views; ++n) {
            const OrthoView view = randomView(random, sigma);
            const Result<LatticeView> lattice = quantiseView(view, glm::ivec3(edge));
            if (lattice) {
                EXPECT_TRUE(fitsNarrow(*lattice, glm::ivec3(edge))) << edge << " " << sigma;
                continue;
            }
            // Too many pixels for one buffer, but a scene may still cast a part of it: the
            // coarsest lattice there, over the whole silhouette.
            LatticeView coarse = quantised(view, glm::ivec3(1));
            while (std::ldexp(1.0, coarse.positionBits - 1) >= 16 * sigma &&
                   coarse.positionBits > 8) {
                --coarse.positionBits;
                for (int a = 0; a < 3; ++a) {
                    coarse.C[a] /= 2;
                    coarse.U[a] /= 2;
                    coarse.V[a] /= 2;
                }
            }
            coarse.C += glm::ivec3(edge / 2) * (1 << coarse.positionBits);
            const auto reach = [&](glm::dvec3 axis) {
                return static_cast<int>((std::abs(axis.x) + std::abs(axis.y) + std::abs(axis.z)) *
                                        edge / 2 * sigma);
            };
            const glm::ivec2 half{reach(view.right) + 2, reach(view.up) + 2};
            coarse.first = -half;
            coarse.size = 2 * half;
            EXPECT_TRUE(fitsNarrow(coarse, glm::ivec3(edge))) << edge << " " << sigma;
        }
    };
    for (const double sigma :
         {1.0 / 64, 0.1, 0.5, 0.99, 1.0, 4.0, 7.5, 16.0, 31.0, 32.0, 33.0, 50.0, 64.0})
        check(128, sigma, 12);
    for (const double sigma : {1.0 / 64, 0.5, 1.0, 4.0, 16.0}) check(256, sigma, 12);
    EXPECT_FALSE(
        fitsNarrow(quantised(viewAlong({1, 2, 3}, 0.25), glm::ivec3(4096)), glm::ivec3(4096)));
}

// Axis, diagonal and isometric views do not notice a turn far below the lattice's resolution; other
// views change no more than the few pixels that lie within it.
TEST(QuantiseView, ATinyTurnChangesNextToNothing) {
    const DenseModel model = figure(2);
    const NaiveOctree tree(model);
    const auto turned = [](OrthoView view) {
        const double angle = 1e-7;
        const glm::dvec3 forward = view.forward;
        view.forward = glm::normalize(forward + angle * view.right);
        view.right = glm::normalize(view.right - angle * forward);
        return view;
    };
    const auto share = [&](const LatticeView& a, const LatticeView& b) {
        const LatticeCaster casterA(tree.view(), a);
        const LatticeCaster casterB(tree.view(), b);
        int solidPixels = 0;
        int changed = 0;
        for (int j = 0; j < a.size.y; ++j) {
            for (int i = 0; i < a.size.x; ++i) {
                const LatticeHit hitA = casterA.cast(a.first + glm::ivec2(i, j));
                const LatticeHit hitB = casterB.cast(a.first + glm::ivec2(i, j));
                solidPixels += hitA.material != 0;
                changed += hitA.material != hitB.material || hitA.voxel != hitB.voxel;
            }
        }
        return double(changed) / solidPixels;
    };
    for (const double sigma : {0.5, 1.0, 1.5, 2.0, 4.0}) {
        for (const glm::dvec3& direction : canonicalDirections()) {
            const OrthoView view = viewAlong(direction, sigma);
            const LatticeView lattice = quantised(view, model.size);
            const LatticeView other = quantised(turned(view), model.size);
            EXPECT_EQ(lattice.D, other.D);
            EXPECT_LE(share(lattice, other), 0.002) << "sigma " << sigma;
        }
    }
    std::mt19937 random(7);
    for (int n = 0; n < 10; ++n) {
        const OrthoView view = randomView(random, 4);
        EXPECT_LE(share(quantised(view, model.size), quantised(turned(view), model.size)), 0.002);
    }
}

}  // namespace
}  // namespace voxprite::test

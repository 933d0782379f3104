// Errors of single pictures, and their means over views.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "app/trade/figures.h"
#include "core/measure/compare.h"

namespace voxprite::trade {

// Of two pictures of one size, with the ids of both (or none).
[[nodiscard]] Result<PictureErrors> compareShown(const ComparedPicture& yardstick,
                                                 std::span<const std::uint32_t> yardstickIds,
                                                 const ComparedPicture& test,
                                                 std::span<const std::uint32_t> testIds);

// As PictureErrors says; what only some views have is the mean over those. PSNR is that of the mean
// squared error.
class ErrorMean {
  public:
    void add(const PictureErrors& errors) { all_.push_back(errors); }
    [[nodiscard]] PictureErrors mean() const;

  private:
    std::vector<PictureErrors> all_;
};

// Over all samples alike; nothing when nothing was added.
class NumberMean {
  public:
    void add(const NumberErrors& errors);
    [[nodiscard]] std::optional<NumberErrors> mean() const { return sum_; }

  private:
    std::optional<NumberErrors> sum_;
};

}  // namespace voxprite::trade

// How far long work has come, for whoever waits for it and may stop it.
#pragma once

#include <functional>
#include <stop_token>
#include <utility>

namespace voxprite {

class Progress {
  public:
    Progress() = default;  // nobody waits
    // `report` is called on the thread that works, with the share that is done, 0 ... 1.
    Progress(std::function<void(double share)> report, std::stop_token stop)
        : report_(std::move(report)), stop_(std::move(stop)) {}

    // Said now and then by the work, which ends early when this is false.
    [[nodiscard]] bool reached(double share) const {
        if (report_) report_(from_ + (to_ - from_) * share);
        return !stop_.stop_requested();
    }
    // Of a part of the work, which lies between two shares of the whole.
    [[nodiscard]] Progress part(double from, double to) const {
        Progress part = *this;
        part.from_ = from_ + (to_ - from_) * from;
        part.to_ = from_ + (to_ - from_) * to;
        return part;
    }

  private:
    std::function<void(double)> report_;
    std::stop_token stop_;
    double from_ = 0.0, to_ = 1.0;
};

}  // namespace voxprite

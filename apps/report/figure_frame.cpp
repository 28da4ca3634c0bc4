// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/figure_frame.h"

#include <fmt/core.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace ridgeline::apps {
namespace {

constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
const cv::Scalar kInk(30.0, 30.0, 30.0);

/// All sizes scale with the width of the picture, so that figures of any size look alike in print.
struct PageLayout {
  explicit PageLayout(int width_px) : text_scale(std::clamp(width_px / 1600.0, 0.35, 3.0)) {}
  [[nodiscard]] int px(double at_1600) const { return cvRound(at_1600 * text_scale); }
  [[nodiscard]] int stroke() const { return std::max(1, px(1.6)); }
  [[nodiscard]] int width_of(const std::string& text) const {
    int below = 0;
    return cv::getTextSize(text, kFont, 0.9 * text_scale, stroke(), &below).width;
  }
  void write(cv::Mat& page, const std::string& text, cv::Point at) const {
    cv::putText(page, text, at, kFont, 0.9 * text_scale, kInk, stroke(), cv::LINE_AA);
  }

  double text_scale;
};

void draw_mark(cv::Mat& page, const LegendEntry& entry, cv::Point at, const PageLayout& layout) {
  const cv::Point right(at.x + layout.px(44), at.y);
  const int width = std::max(2, layout.px(5));
  switch (entry.mark) {
    case LegendMark::kLine:
      cv::line(page, at, right, entry.colours[0], width, cv::LINE_AA);
      return;
    case LegendMark::kDashedLine:
      for (int i = 0; i < 5; i += 2) {
        cv::line(page, at + (right - at) * (i / 5.0), at + (right - at) * ((i + 1) / 5.0),
                 entry.colours[0], width, cv::LINE_AA);
      }
      return;
    case LegendMark::kPoints:
      for (std::size_t i = 0; i < 3; ++i) {
        const double along = 0.2 + 0.3 * static_cast<double>(i);
        cv::circle(page, at + (right - at) * along, layout.px(6),
                   entry.colours[i % entry.colours.size()], cv::FILLED, cv::LINE_AA);
      }
      return;
  }
}

/// Draws the entries from left to right, starting a new row when one is full. Returns the y of the
/// last row.
int draw_legend(cv::Mat& page,
                const std::vector<LegendEntry>& legend,
                int top,
                const PageLayout& at) {
  const int margin = at.px(24);
  int x = margin;
  int y = top + at.px(36);
  for (const LegendEntry& entry : legend) {
    const int width = at.px(44 + 14 + 34) + at.width_of(entry.text);
    if (x > margin && x + width > page.cols - margin) {
      x = margin;
      y += at.px(42);
    }
    draw_mark(page, entry, {x, y - at.px(9)}, at);
    at.write(page, entry.text, {x + at.px(44 + 14), y});
    x += width;
  }
  return y;
}

void draw_scale(cv::Mat& page, const FigureFrame& frame, int y, const PageLayout& at) {
  const int margin = at.px(24);
  const double bar_m = scale_bar_m(0.2 * page.cols / frame.px_per_m);
  const cv::Point left(margin, y);
  const cv::Point right(margin + cvRound(bar_m * frame.px_per_m), y);
  const cv::Point tick(0, at.px(8));
  cv::line(page, left, right, kInk, at.px(3), cv::LINE_AA);
  for (const cv::Point& end : {left, right}) {
    cv::line(page, end - tick, end + tick, kInk, at.px(3), cv::LINE_AA);
  }
  const std::string note = frame.scale_note.empty() ? "" : ", " + frame.scale_note;
  at.write(page, fmt::format("{:g} m{}", bar_m, note), {right.x + at.px(14), y + at.px(10)});
}

/// The height of the legend in pixels, measured by drawing it on a page that is discarded.
int legend_height(int cols, const std::vector<LegendEntry>& legend, const PageLayout& at) {
  cv::Mat page(1, cols, CV_8UC3);
  return legend.empty() ? 0 : draw_legend(page, legend, 0, at) + at.px(10);
}

}  // namespace

double scale_bar_m(double longest_m) {
  const double power = std::pow(10.0, std::floor(std::log10(longest_m)));
  for (const double times : {5.0, 2.0}) {
    if (times * power <= longest_m) return times * power;
  }
  return power;
}

cv::Mat framed(const cv::Mat& picture, const FigureFrame& frame) {
  const PageLayout at(picture.cols);
  const int head = at.px(56);
  const int legend = legend_height(picture.cols, frame.legend, at);
  const int scale = frame.px_per_m > 0.0 ? at.px(44) : 0;
  cv::Mat page(head + picture.rows + legend + scale + at.px(12), picture.cols, CV_8UC3,
               cv::Scalar::all(255.0));
  at.write(page, frame.title, {at.px(24), at.px(38)});
  picture.copyTo(page(cv::Rect(0, head, picture.cols, picture.rows)));
  if (legend > 0) draw_legend(page, frame.legend, head + picture.rows, at);
  if (scale > 0) draw_scale(page, frame, head + picture.rows + legend + at.px(22), at);
  return page;
}

}  // namespace ridgeline::apps

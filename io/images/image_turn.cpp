// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/image_turn.h"

#include <opencv2/core.hpp>

#include <utility>

namespace ridgeline::io {
namespace {

/// A turn is an optional transposition, followed by optional reversals of columns and rows.
struct TurnSteps {
  bool transposes, reverses_columns, reverses_rows;
};

TurnSteps steps_of(ImageTurn turn) {
  switch (turn) {
    case ImageTurn::kNone:
      return {false, false, false};
    case ImageTurn::kFlipColumns:
      return {false, true, false};
    case ImageTurn::kHalf:
      return {false, true, true};
    case ImageTurn::kFlipRows:
      return {false, false, true};
    case ImageTurn::kTranspose:
      return {true, false, false};
    case ImageTurn::kClockwise:
      return {true, true, false};
    case ImageTurn::kTransverse:
      return {true, true, true};
    case ImageTurn::kCounterClockwise:
      return {true, false, true};
  }
  return {false, false, false};
}

}  // namespace

Window stored_window(const Window& window, ImageTurn turn, int stored_width, int stored_height) {
  const TurnSteps steps = steps_of(turn);
  const int turned_width = steps.transposes ? stored_height : stored_width;
  const int turned_height = steps.transposes ? stored_width : stored_height;
  Window stored = window;
  if (steps.reverses_columns) stored.column = turned_width - window.column - window.width;
  if (steps.reverses_rows) stored.row = turned_height - window.row - window.height;
  if (steps.transposes) {
    std::swap(stored.column, stored.row);
    std::swap(stored.width, stored.height);
  }
  return stored;
}

cv::Mat turned(const cv::Mat& stored, ImageTurn turn) {
  constexpr int kColumns = 1;
  constexpr int kRows = 0;
  const TurnSteps steps = steps_of(turn);
  cv::Mat image = stored;
  const auto replace_by = [&image](const auto& change) {
    cv::Mat changed;
    change(image, changed);
    image = changed;
  };
  if (steps.transposes) replace_by([](const auto& a, auto& b) { cv::transpose(a, b); });
  if (steps.reverses_columns) replace_by([](const auto& a, auto& b) { cv::flip(a, b, kColumns); });
  if (steps.reverses_rows) replace_by([](const auto& a, auto& b) { cv::flip(a, b, kRows); });
  return image;
}

}  // namespace ridgeline::io

// SPDX-License-Identifier: BSD-3-Clause
#include "io/orientation/stated_cameras.h"

#include "io/error.h"
#include "io/orientation/camera_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace ridgeline::io {

void add_stated_cameras(const std::string& path,
                        const OrientationOptions& options,
                        const std::vector<std::string>& names,
                        Orientation& orientation) {
  if (options.cameras.empty()) return;
  CameraFile file = read_cameras(options.cameras, names);
  orientation.cameras = std::move(file.cameras);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto camera = std::ranges::find(orientation.cameras, names[i], &Camera::name);
    if (camera == orientation.cameras.end() && !file.is_only_one) {
      throw IoError(path, fmt::format("image {} has camera '{}', which is missing in {}",
                                      orientation.images[i].name, names[i], options.cameras));
    }
    orientation.images[i].camera =
        file.is_only_one ? 0 : static_cast<std::size_t>(camera - orientation.cameras.begin());
  }
}

}  // namespace ridgeline::io

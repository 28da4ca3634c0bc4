// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <utility>

namespace ridgeline::io::laz {

/// Versions of the layered items. Version 3 keeps two mistakes of the first encoder, which are part
/// of the format; version 4 corrects both. They matter only with several scanner channels.
enum class ItemVersion { k3 = 3, k4 = 4 };

/// Models and previous value of an item (colour, wave packet, extra bytes) for each of the four
/// scanner channels. When a channel first occurs, its models are new and its previous value is that
/// of the channel before it.
template <typename Models, typename Value>
class ChannelContexts {
 public:
  ChannelContexts(ItemVersion version, unsigned channel, Models fresh, Value first)
      : version_(version), fresh_(std::move(fresh)), current_(channel) {
    create(channel, first);
  }

  struct Selected {
    Models& models;
    Value& last;
  };

  /// The context of the next value. On return to a channel, version 3 takes the previous value from
  /// the channel being left, and stores the new value there.
  Selected select(unsigned channel) {
    unsigned last_of = current_;
    if (channel != current_) {
      const bool is_new = !channels_[channel];
      if (is_new) create(channel, channels_[current_]->last);
      if (is_new || version_ == ItemVersion::k4) last_of = channel;
      current_ = channel;
    }
    return {channels_[channel]->models, channels_[last_of]->last};
  }

 private:
  struct Context {
    Models models;
    Value last;
  };

  void create(unsigned channel, const Value& last) {
    channels_[channel] = std::make_unique<Context>(Context{fresh_, last});
  }

  ItemVersion version_;
  Models fresh_;
  std::array<std::unique_ptr<Context>, 4> channels_;
  unsigned current_;
};

}  // namespace ridgeline::io::laz

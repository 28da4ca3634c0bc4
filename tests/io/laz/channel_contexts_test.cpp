// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/channel_contexts.h"

#include <gtest/gtest.h>

namespace ridgeline::io::laz {
namespace {

// The "models" of this test count how often they are selected.
using Contexts = ChannelContexts<int, int>;

TEST(ChannelContexts, CopiesTheValueOfTheChannelBeforeIntoANewOne) {
  for (const ItemVersion version : {ItemVersion::k3, ItemVersion::k4}) {
    Contexts contexts(version, 2, 0, 100);
    contexts.select(2).last = 101;
    const auto [models, last] = contexts.select(0);
    EXPECT_EQ(last, 101);
    last = 200;
    EXPECT_EQ(contexts.select(0).last, 200);
  }
}

TEST(ChannelContexts, KeepsFourInterleavedChannelsApartInVersion4) {
  Contexts contexts(ItemVersion::k4, 0, 0, 0);
  for (int round = 0; round < 5; ++round) {
    for (unsigned channel = 0; channel < 4; ++channel) {
      auto [models, last] = contexts.select(channel);
      EXPECT_EQ(models, round);
      const int before = round == 0 ? 0 : 10 * static_cast<int>(channel) + round - 1;
      if (round > 0 || channel == 0) {
        EXPECT_EQ(last, before);
      }
      ++models;
      last = 10 * static_cast<int>(channel) + round;
    }
  }
}

TEST(ChannelContexts, TakesTheValueOfTheChannelThatIsLeftInVersion3) {
  Contexts contexts(ItemVersion::k3, 0, 0, 1);
  contexts.select(1).last = 2;  // new: its own value from now on
  {
    auto [models, last] = contexts.select(0);  // back: models of 0, value of 1
    EXPECT_EQ(last, 2);
    models = 7;
    last = 3;
  }
  EXPECT_EQ(contexts.select(0).last, 1) << "the next value of the same channel is its own again";
  EXPECT_EQ(contexts.select(0).models, 7);
  EXPECT_EQ(contexts.select(1).last, 1) << "the return to 1 takes the value of 0";
  EXPECT_EQ(contexts.select(1).last, 3) << "the value of the return to 0 was stored in 1";
}

}  // namespace
}  // namespace ridgeline::io::laz

#include "ui/proposal_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ui/forecast.h"

namespace guidelight {
namespace {

using ::testing::ElementsAre;

TEST(ProposalTable, IsSortedByAnyColumnUpwardsAndDownwards) {
  const std::vector<ProposalRow> rows = {{"door", {"", 0.2, 0.5, 0.1}},
                                         {"window", {"", 0.1, 0.5, 0.7}},
                                         {"attic", {"", 0.4, 0.1, 0.2}}};
  EXPECT_THAT(sorted_rows(rows, ProposalColumn::Name, true), ElementsAre(2, 0, 1));
  EXPECT_THAT(sorted_rows(rows, ProposalColumn::Proposed, false), ElementsAre(2, 0, 1));
  EXPECT_THAT(sorted_rows(rows, ProposalColumn::Light, false), ElementsAre(1, 2, 0));
  EXPECT_THAT(sorted_rows(rows, ProposalColumn::Light, true), ElementsAre(0, 2, 1));
  EXPECT_THAT(sorted_rows(rows, ProposalColumn::Accepted, true), ElementsAre(2, 0, 1))
      << "rows that are alike keep their order";
}

TEST(Forecast, HalfTheErrorTakesFourTimesAsLong) {
  EXPECT_DOUBLE_EQ(seconds_until_error(10, 0.2, 0.1), 30);
  EXPECT_DOUBLE_EQ(seconds_until_error(10, 0.1, 0.1), 0);
  EXPECT_DOUBLE_EQ(seconds_until_error(10, 0.05, 0.1), 0);
}

}  // namespace
}  // namespace guidelight

// SPDX-License-Identifier: Apache-2.0
// What every ResultStore must do. A backend joins as with job_store_contract.h.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "api/digest.h"
#include "server/storage/result_store.h"

namespace bouguer::server {

inline const JobId kResultJob = "01890a5d-ac96-774b-bcce-b302099a8057";

template <class Backend>
class ResultStoreContract : public testing::Test {
  protected:
    Backend backend_;
    std::unique_ptr<ResultStore> store_ = backend_.make();
};
TYPED_TEST_SUITE_P(ResultStoreContract);

TYPED_TEST_P(ResultStoreContract, GivesBackTheBytesAndTheirDigest) {
    const std::string bytes("\0\x89PNG\r\n\xff", 8);
    ASSERT_TRUE(this->store_->put(kResultJob, {{"image.png", bytes}, {"empty.csv", ""}}));
    const auto file = this->store_->get(kResultJob, "image.png");
    ASSERT_TRUE(file);
    EXPECT_EQ(file->content.all().value(), bytes);
    EXPECT_EQ(file->digest, api::sha256_hex(bytes));
    EXPECT_EQ(this->store_->get(kResultJob, "empty.csv")->content.all().value(), "");
    EXPECT_EQ(this->store_->names(kResultJob).value(),
              (std::vector<std::string>{"empty.csv", "image.png"}));
}

TYPED_TEST_P(ResultStoreContract, KnowsNothingOfWhatWasNotStored) {
    EXPECT_EQ(this->store_->get(kResultJob, "image.png").error().kind, ErrorKind::NotFound);
    EXPECT_TRUE(this->store_->names(kResultJob)->empty());
    ASSERT_TRUE(this->store_->put(kResultJob, {{"image.png", "a"}}));
    EXPECT_EQ(this->store_->get(kResultJob, "image.exr").error().kind, ErrorKind::NotFound);
}

TYPED_TEST_P(ResultStoreContract, ASecondPutTakesThePlaceOfTheFirst) {
    ASSERT_TRUE(this->store_->put(kResultJob, {{"image.png", "old"}, {"gone.csv", "x"}}));
    ASSERT_TRUE(this->store_->put(kResultJob, {{"image.png", "new"}}));
    EXPECT_EQ(this->store_->get(kResultJob, "image.png")->content.all().value(), "new");
    EXPECT_FALSE(this->store_->get(kResultJob, "gone.csv"));
}

TYPED_TEST_P(ResultStoreContract, RemovesEverythingOfAJob) {
    ASSERT_TRUE(this->store_->put(kResultJob, {{"image.png", "a"}}));
    ASSERT_TRUE(this->store_->remove(kResultJob));
    EXPECT_FALSE(this->store_->get(kResultJob, "image.png"));
    EXPECT_TRUE(this->store_->remove(kResultJob)) << "removing nothing is no error";
}

TYPED_TEST_P(ResultStoreContract, RefusesNamesThatLeaveTheFolder) {
    for (const std::string name : {"../x", "a/b", "", ".hidden", "a b", "IMAGE", "x\n"}) {
        EXPECT_FALSE(this->store_->put(kResultJob, {{name, "a"}})) << name;
        EXPECT_EQ(this->store_->get(kResultJob, name).error().kind, ErrorKind::NotFound) << name;
    }
    for (const std::string id : {"..", "", "/etc", "01890A5D-AC96-774B-BCCE-B302099A8057"}) {
        EXPECT_FALSE(this->store_->put(id, {{"a", "a"}})) << id;
        EXPECT_FALSE(this->store_->get(id, "passwd")) << id;
    }
}

TYPED_TEST_P(ResultStoreContract, KnowsWhichJobsHaveResults) {
    EXPECT_TRUE(this->store_->jobs()->empty());
    ASSERT_TRUE(this->store_->put(kResultJob, {{"image.png", "a"}}));
    EXPECT_EQ(this->store_->jobs().value(), std::vector<JobId>{kResultJob});
    ASSERT_TRUE(this->store_->set_aside(kResultJob));
    EXPECT_TRUE(this->store_->jobs()->empty());
    EXPECT_FALSE(this->store_->get(kResultJob, "image.png"));
}

REGISTER_TYPED_TEST_SUITE_P(ResultStoreContract, GivesBackTheBytesAndTheirDigest,
                            KnowsNothingOfWhatWasNotStored, ASecondPutTakesThePlaceOfTheFirst,
                            RemovesEverythingOfAJob, RefusesNamesThatLeaveTheFolder,
                            KnowsWhichJobsHaveResults);

}  // namespace bouguer::server

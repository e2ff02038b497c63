// SPDX-License-Identifier: Apache-2.0
#include "server/storage/folder_result_store.h"

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "tests/server/storage/result_store_contract.h"
#include "tests/server/storage/temporary_folder.h"

namespace bouguer::server {
namespace {

struct FolderBackend {
    TemporaryFolder folder;
    std::unique_ptr<ResultStore> make() {
        return std::move(FolderResultStore::open(folder.path() / "results").value());
    }
};

INSTANTIATE_TYPED_TEST_SUITE_P(Folder, ResultStoreContract, FolderBackend);

class FolderResultStoreTest : public testing::Test {
  protected:
    TemporaryFolder folder_;
    std::filesystem::path root_ = folder_.path() / "results";
};

TEST_F(FolderResultStoreTest, KeepsFilesWhenItIsOpenedAgain) {
    ASSERT_TRUE((*FolderResultStore::open(root_))->put(kResultJob, {{"image.png", "abc"}}));
    EXPECT_EQ(
        (*FolderResultStore::open(root_))->get(kResultJob, "image.png")->content.all().value(),
        "abc");
}

/// Overwrites bytes of a file in its place.
void overwrite(const std::filesystem::path& file, std::streamoff at, const std::string& bytes) {
    std::fstream out(file, std::ios::in | std::ios::out | std::ios::binary);
    out.seekp(at);
    out << bytes;
}

TEST_F(FolderResultStoreTest, NoticesDamage) {
    const auto archive = root_ / (kResultJob + ".tar");
    auto store = FolderResultStore::open(root_);
    ASSERT_TRUE(store);
    ASSERT_TRUE((*store)->put(kResultJob, {{"image.png", "abc"}}));
    ASSERT_TRUE((*store)->get(kResultJob, "image.png"));
    std::ifstream in(archive, std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(in), {}};
    // Also after it was read and found well.
    overwrite(archive, static_cast<std::streamoff>(whole.find("abc")), "abd");
    EXPECT_EQ((*store)->get(kResultJob, "image.png").error().code, "result-damaged");
    overwrite(archive, static_cast<std::streamoff>(whole.find("abc")), "abc");
    EXPECT_TRUE((*store)->get(kResultJob, "image.png"));
    for (const std::size_t size :
         {whole.size() / 2, std::size_t{600}, std::size_t{3}, std::size_t{0}}) {
        std::filesystem::resize_file(archive, size);
        EXPECT_EQ((*store)->get(kResultJob, "image.png").error().code, "result-damaged") << size;
        EXPECT_FALSE((*store)->names(kResultJob)) << size;
    }
}

// What is served is the file that was opened, whatever becomes of its name.
TEST_F(FolderResultStoreTest, GivesOutParts) {
    auto store = FolderResultStore::open(root_);
    ASSERT_TRUE((*store)->put(kResultJob, {{"image.png", std::string(1'000'000, 'x')}}));
    const auto file = (*store)->get(kResultJob, "image.png");
    ASSERT_TRUE(file);
    EXPECT_FALSE(file->content.is_in_memory());
    ASSERT_TRUE((*store)->remove(kResultJob));
    EXPECT_EQ(file->content.all().value(), std::string(1'000'000, 'x'));
}

TEST_F(FolderResultStoreTest, WritesOneFileThatTarUnderstands) {
    auto store = FolderResultStore::open(root_);
    ASSERT_TRUE((*store)->put(kResultJob, {{"image.png", std::string(513, 'x')}, {"a.csv", ""}}));
    const std::string command =
        "cd '" + root_.string() + "' && tar xf " + kResultJob +
        ".tar && sha256sum --status -c SHA256SUMS && test $(ls | wc -l) = 4";
    EXPECT_EQ(std::system(command.c_str()), 0);
}

class OldResultFolder : public FolderResultStoreTest {
  protected:
    OldResultFolder() {
        std::filesystem::create_directories(folder_of_job_);
        std::ofstream(folder_of_job_ / "image.png") << "abc";
        std::ofstream(folder_of_job_ / "SHA256SUMS") << api::sha256_hex("abc") << "  image.png\n";
    }
    std::filesystem::path folder_of_job_ = root_ / kResultJob;
    std::unique_ptr<FolderResultStore> store_ = std::move(*FolderResultStore::open(root_));
};

TEST_F(OldResultFolder, IsRead) {
    EXPECT_EQ(store_->get(kResultJob, "image.png")->content.all().value(), "abc");
    EXPECT_EQ(store_->get(kResultJob, "image.exr").error().kind, ErrorKind::NotFound);
    EXPECT_EQ(store_->names(kResultJob).value(), std::vector<std::string>{"image.png"});
    EXPECT_EQ(store_->jobs().value(), std::vector<JobId>{kResultJob});
    ASSERT_TRUE(store_->remove(kResultJob));
    EXPECT_TRUE(store_->names(kResultJob)->empty());
}

TEST_F(OldResultFolder, ItsDamageIsNoticed) {
    std::ofstream(folder_of_job_ / "image.png") << "abd";
    EXPECT_EQ(store_->get(kResultJob, "image.png").error().code, "result-damaged");
    std::filesystem::remove(folder_of_job_ / "image.png");
    EXPECT_EQ(store_->get(kResultJob, "image.png").error().code, "result-damaged");
    std::filesystem::remove(folder_of_job_ / "SHA256SUMS");
    EXPECT_EQ(store_->get(kResultJob, "image.png").error().code, "result-damaged");
}

// What a crash before the rename leaves is not seen, and is gone after the next start.
TEST_F(FolderResultStoreTest, ForgetsHalfWrittenResults) {
    const auto part = root_ / (".part-" + kResultJob);
    std::filesystem::create_directories(part);
    std::ofstream(part / "image.png") << "ab";
    auto store = FolderResultStore::open(root_);
    ASSERT_TRUE(store);
    EXPECT_FALSE((*store)->get(kResultJob, "image.png"));
    EXPECT_FALSE(std::filesystem::exists(part));
}

TEST_F(FolderResultStoreTest, SaysWhenItCannotWrite) {
    std::ofstream(folder_.path() / "file") << "x";
    EXPECT_EQ(FolderResultStore::open(folder_.path() / "file" / "results").error().kind,
              ErrorKind::Internal);
    auto store = FolderResultStore::open(root_);
    ASSERT_TRUE(store);
    std::filesystem::remove_all(root_);
    EXPECT_EQ((*store)->put(kResultJob, {{"image.png", "abc"}}).error().kind, ErrorKind::Internal);
}

}  // namespace
}  // namespace bouguer::server

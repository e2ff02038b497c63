// SPDX-License-Identifier: Apache-2.0
#include "server/storage/result_archive.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include "server/file_descriptor.h"

namespace bouguer::server {
namespace {

class ResultArchive : public testing::Test {
  protected:
    std::string text_of(const ResultFiles& files) const {
        std::string text;
        const ArchiveText archive(files, 0);
        for (const std::string_view piece : archive.pieces()) text += piece;
        return text;
    }
    Result<std::map<std::string, ArchivedFile>> read(const std::string& text) {
        const FileDescriptor file(::memfd_create("archive", MFD_CLOEXEC));
        EXPECT_EQ(::write(file.get(), text.data(), text.size()), static_cast<ssize_t>(text.size()));
        return read_archive(file.get());
    }
    const ResultFiles files_{{"a.csv", ""}, {"b.png", std::string(512, 'b')}, {"c", "\0c"}};
};

TEST_F(ResultArchive, SaysWhereEverythingStands) {
    const std::string text = text_of(files_);
    const auto places = read(text);
    ASSERT_TRUE(places) << places.error().message;
    ASSERT_EQ(places->size(), files_.size());
    for (const auto& [name, bytes] : files_) {
        const ArchivedFile& place = places->at(name);
        EXPECT_EQ(text.substr(place.offset, place.bytes), bytes) << name;
    }
}

TEST_F(ResultArchive, OfNothingIsEmpty) { EXPECT_TRUE(read(text_of({}))->empty()); }

// No length is taken for a whole archive, and no changed byte of a header leads anywhere.
TEST_F(ResultArchive, RefusesWhatIsCutOrChanged) {
    const std::string text = text_of(files_);
    for (std::size_t size = 0; size < text.size() - 1024; size += 100) {
        EXPECT_FALSE(read(text.substr(0, size))) << size;
    }
    for (std::size_t at = 0; at < 512; ++at) {
        if (at == 154 || at == 155) continue;  // they end the checksum and say nothing
        std::string changed = text;
        changed[1024 + at] = static_cast<char>(changed[1024 + at] ^ 1);  // of the first result
        const auto places = read(changed);
        EXPECT_FALSE(places) << at;
        if (!places) {
            EXPECT_EQ(places.error().code, "result-damaged") << at;
        }
    }
    EXPECT_FALSE(read(std::string(5000, 'x')));
    EXPECT_FALSE(read(std::string(5000, '\0')));
}

}  // namespace
}  // namespace bouguer::server

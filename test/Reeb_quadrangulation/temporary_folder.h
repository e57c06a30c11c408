// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef REEBQUAD_TEST_TEMPORARY_FOLDER_H
#define REEBQUAD_TEST_TEMPORARY_FOLDER_H

#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

/// A folder that is removed with all that is in it.
class Temporary_folder {
public:
  Temporary_folder() {
    std::string name = (std::filesystem::temp_directory_path() / "reebquad-test-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    m_path = name;
  }
  ~Temporary_folder() {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }
  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;

  std::string path(const std::string& name) const { return (m_path / name).string(); }
  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

private:
  std::filesystem::path m_path;
};

inline std::string contents(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

#endif // REEBQUAD_TEST_TEMPORARY_FOLDER_H

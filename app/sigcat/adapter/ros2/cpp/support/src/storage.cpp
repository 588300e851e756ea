#include "PACKAGE_NAME/storage.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "rclcpp/rclcpp.hpp"

namespace PACKAGE_NAME
{

namespace
{

/// Writes a file that no other process writes, so that it stays, whatever happens next. `path`
/// ends with the letters for its own part of the name. 0, or the error that it cannot.
int write_file(std::string & path, const std::string & text)
{
  const int file = mkostemp(path.data(), O_CLOEXEC);
  if (file < 0) {
    return errno;
  }
  int error = fchmod(file, S_IRUSR | S_IWUSR | S_IRGRP | S_IROTH) == 0 ? 0 : errno;
  std::size_t written = 0;
  while (error == 0 && written < text.size()) {
    const ssize_t count = write(file, text.data() + written, text.size() - written);
    if (count >= 0) {
      written += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      error = errno;
    }
  }
  if (error == 0 && fsync(file) != 0) {
    error = errno;
  }
  if (close(file) != 0 && error == 0) {
    error = errno;
  }
  return error;
}

void sync_folder(const std::filesystem::path & path)
{
  const int folder = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder >= 0) {
    fsync(folder);
    close(folder);
  }
}

}  // namespace

std::filesystem::path storage_file(
  const std::string & folder, const std::string & node, std::size_t domain)
{
  std::filesystem::path path = folder;
  if (folder.empty()) {
    const char * const ros_home = std::getenv("ROS_HOME");
    const char * const home = std::getenv("HOME");
    path = ros_home != nullptr && *ros_home != '\0' ? std::filesystem::path(ros_home) :
      std::filesystem::path(home != nullptr ? home : ".") / ".ros";
    path /= "PACKAGE_NAME";
  }
  std::string name = node.substr(node.find_first_not_of('/'));
  std::replace(name.begin(), name.end(), '/', '.');
  return path / (name + (domain == 0U ? "" : "-" + std::to_string(domain)) + ".txt");
}

Storage::Storage(std::filesystem::path file, rclcpp::Logger logger)
: file_(std::move(file)), logger_(std::move(logger))
{
}

void Storage::load()
{
  std::error_code error;
  const auto status = std::filesystem::symlink_status(file_, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    RCLCPP_INFO(logger_, "nothing is stored in %s", file_.c_str());
    values_.clear();
    is_good_ = true;
    return;
  }
  std::ostringstream text;
  text << std::ifstream(file_, std::ios::binary).rdbuf();
  const std::optional<StoredValues> found = parse_stored(text.str());
  values_ = found.value_or(StoredValues{});
  is_good_ = found.has_value();
}

void Storage::set_aside()
{
  std::filesystem::path broken = file_;
  broken += ".broken";
  std::error_code error;
  std::filesystem::rename(file_, broken, error);
  const std::string kept = error ? error.message() : "it is kept as " + broken.string();
  RCLCPP_ERROR(
    logger_, "%s cannot be read, or is broken, and nothing of it is used; %s",
    file_.c_str(), kept.c_str());
  values_.clear();
  is_good_ = true;
}

void Storage::save()
{
  std::string next = file_.string() + ".XXXXXX";
  std::error_code error;
  std::filesystem::create_directories(file_.parent_path(), error);
  const int problem = write_file(next, stored_text(values_));
  if (problem != 0) {
    RCLCPP_ERROR(logger_, "%s cannot be written: %s", next.c_str(), std::strerror(problem));
    std::filesystem::remove(next, error);
    return;
  }
  std::filesystem::rename(next, file_, error);
  if (error) {
    RCLCPP_ERROR(logger_, "%s cannot be written: %s", file_.c_str(), error.message().c_str());
    return;
  }
  sync_folder(file_.parent_path());
}

}  // namespace PACKAGE_NAME

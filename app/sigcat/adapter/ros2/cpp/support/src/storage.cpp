#include "PACKAGE_NAME/storage.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include "rclcpp/rclcpp.hpp"

namespace PACKAGE_NAME
{

namespace
{

constexpr char kFirstLine[] = "sigcat 1";

template<typename NumberT>
std::string shortest(NumberT value)
{
  char text[64];
  const auto end = std::to_chars(text, text + sizeof(text), value);
  return std::string(text, end.ptr);
}

template<typename NumberT>
bool read_number(const std::string & text, NumberT & value)
{
  NumberT found{};
  const char * const last = text.data() + text.size();
  const auto end = std::from_chars(text.data(), last, found);
  const bool is_whole = end.ec == std::errc() && end.ptr == last;
  value = is_whole ? found : value;
  return is_whole;
}

/// Writes a file so that it stays, whatever happens next. 0, or the error that it cannot.
int write_file(const std::filesystem::path & path, const std::string & text)
{
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) {
    return errno;
  }
  int error = 0;
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

std::filesystem::path storage_file(const std::string & folder, const std::string & node)
{
  std::filesystem::path path = folder;
  if (folder.empty()) {
    const char * const ros_home = std::getenv("ROS_HOME");
    const char * const home = std::getenv("HOME");
    path = ros_home != nullptr ? std::filesystem::path(ros_home) :
      std::filesystem::path(home != nullptr ? home : ".") / ".ros";
    path /= "PACKAGE_NAME";
  }
  std::string name = node.substr(node.find_first_not_of('/'));
  std::replace(name.begin(), name.end(), '/', '.');
  return path / (name + ".txt");
}

std::string text_of(bool value) {return value ? "true" : "false";}
std::string text_of(float value) {return shortest(value);}
std::string text_of(double value) {return shortest(value);}
std::string text_of(int64_t value) {return shortest(value);}
std::string text_of(uint64_t value) {return shortest(value);}

bool read_text(const std::string & text, bool & value)
{
  value = text == "true" || (text != "false" && value);
  return text == "true" || text == "false";
}

bool read_text(const std::string & text, float & value) {return read_number(text, value);}
bool read_text(const std::string & text, double & value) {return read_number(text, value);}
bool read_text(const std::string & text, int8_t & value) {return read_number(text, value);}
bool read_text(const std::string & text, int16_t & value) {return read_number(text, value);}
bool read_text(const std::string & text, int32_t & value) {return read_number(text, value);}
bool read_text(const std::string & text, int64_t & value) {return read_number(text, value);}
bool read_text(const std::string & text, uint8_t & value) {return read_number(text, value);}
bool read_text(const std::string & text, uint16_t & value) {return read_number(text, value);}
bool read_text(const std::string & text, uint32_t & value) {return read_number(text, value);}
bool read_text(const std::string & text, uint64_t & value) {return read_number(text, value);}

Storage::Storage(std::filesystem::path file, rclcpp::Logger logger)
: file_(std::move(file)), logger_(std::move(logger))
{
}

void Storage::load()
{
  values_.clear();
  is_good_ = true;
  std::ifstream input(file_);
  std::string line;
  if (!input.is_open()) {
    std::error_code error;
    is_good_ = !std::filesystem::exists(std::filesystem::symlink_status(file_, error));
    if (is_good_) {
      RCLCPP_INFO(logger_, "nothing is stored in %s", file_.c_str());
    }
    return;
  }
  is_good_ = std::getline(input, line) && !input.eof() && line == kFirstLine;
  while (is_good_ && std::getline(input, line)) {
    is_good_ = !input.eof() && parse(line);  // each line has an end
  }
}

bool Storage::parse(const std::string & line)
{
  const std::size_t colon = line.find(": ");
  if (colon == std::string::npos || colon == 0) {
    return false;
  }
  return values_.emplace(line.substr(0, colon), line.substr(colon + 2)).second;
}

void Storage::set_aside()
{
  std::filesystem::path broken = file_;
  broken += ".broken";
  std::error_code error;
  std::filesystem::rename(file_, broken, error);
  RCLCPP_ERROR(
    logger_, "%s cannot be read, or is broken; it is kept as %s, and nothing of it is used",
    file_.c_str(), broken.c_str());
  values_.clear();
  is_good_ = true;
}

void Storage::save()
{
  std::string text = std::string(kFirstLine) + "\n";
  for (const auto & value : values_) {
    text += value.first + ": " + value.second + "\n";
  }
  std::filesystem::path next = file_;
  next += ".new";
  std::error_code error;
  std::filesystem::create_directories(file_.parent_path(), error);
  const int problem = write_file(next, text);
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

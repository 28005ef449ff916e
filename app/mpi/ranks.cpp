#include "app/mpi/ranks.hpp"

#include <mpi.h>

#include <chrono>
#include <cstdint>
#include <exception>
#include <optional>
#include <stdexcept>
#include <thread>

#include "input/input_error.hpp"
#include "input/numerical_failure.hpp"

namespace secular::app {
namespace {

enum Tag { work_tag = 1, number_tag, answer_tag, end_tag };

// MPI itself would wait in a busy loop, on processors that others need.
MPI_Status wait_for_message() {
  for (;;) {
    MPI_Status status;
    int there = 0;
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
    if (there) return status;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

void send(int rank, Tag tag, const std::string& text) {
  MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, rank, tag, MPI_COMM_WORLD);
}

std::string received(const MPI_Status& status) {
  int size = 0;
  MPI_Get_count(&status, MPI_CHAR, &size);
  std::string text(static_cast<std::size_t>(size), '\0');
  MPI_Recv(text.data(), size, MPI_CHAR, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return text;
}

// An exception as an answer, and the answer as an exception again.
blind::Answer thrown_answer() {
  try {
    throw;
  } catch (const InputError& e) {
    return {{"thrown", "input"}, {"text", {e.file(), e.place(), e.wrong(), e.right()}}};
  } catch (const NumericalFailure& e) {
    return {{"thrown", "numbers"}, {"ending", static_cast<int>(e.ending())}, {"text", {e.what()}}};
  } catch (const std::exception& e) {
    return {{"thrown", "other"}, {"text", {e.what()}}};
  }
}

[[noreturn]] void throw_again(const blind::Answer& answer) {
  const auto text = answer.at("text").get<std::vector<std::string>>();
  if (answer.at("thrown") == "input") throw InputError(text.at(0), text.at(1), text.at(2), text.at(3));
  if (answer.at("thrown") == "numbers")
    throw NumericalFailure(static_cast<Ending>(answer.at("ending").get<int>()), text.at(0));
  throw std::runtime_error(text.at(0));
}

}  // namespace

Ranks::Ranks(int& argc, char**& argv) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  MPI_Comm here;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &here);
  int here_size = 1;
  MPI_Comm_size(here, &here_size);
  MPI_Comm_free(&here);
  on_this_machine_ = static_cast<unsigned>(here_size);
}

Ranks::~Ranks() {
  MPI_Finalize();
}

std::vector<blind::Answer> Ranks::hand_out(const blind::CampaignWork& work, std::size_t count,
                                           const blind::Progress& progress) const {
  std::vector<blind::Answer> answers(count);
  std::vector<std::size_t> given(static_cast<std::size_t>(size_));
  std::optional<blind::Answer> thrown;
  std::size_t next = 0, done = 0, at_work = 0;
  const std::string text = blind::text_of(work);
  const auto give = [&](int rank) {
    if (next == count || thrown) return;
    send(rank, number_tag, std::to_string(next));
    given[static_cast<std::size_t>(rank)] = next++;
    ++at_work;
  };
  for (int rank = 1; rank < size_; ++rank) {
    send(rank, work_tag, text);
    give(rank);
  }
  while (at_work > 0) {
    const MPI_Status status = wait_for_message();
    blind::Answer answer = blind::Answer::parse(received(status));
    --at_work;
    if (answer.contains("thrown"))
      thrown = std::move(answer);
    else
      answers[given[static_cast<std::size_t>(status.MPI_SOURCE)]] = std::move(answer);
    give(status.MPI_SOURCE);
    if (progress) progress(++done, count);
  }
  if (thrown) throw_again(*thrown);
  return answers;
}

void Ranks::dismiss() const {
  for (int rank = 1; rank < size_; ++rank) send(rank, end_tag, "");
}

void Ranks::serve() const {
  std::string text;
  blind::Performer perform;
  for (;;) {
    const MPI_Status status = wait_for_message();
    const std::string message = received(status);
    if (status.MPI_TAG == end_tag) return;
    if (status.MPI_TAG == work_tag) {
      text = message;
      perform = nullptr;
      continue;
    }
    blind::Answer answer;
    try {
      if (!perform) {
        blind::CampaignWork work = blind::work_of(text);
        work.how.threads = on_this_machine_;  // they share the processors
        perform = blind::performer_of(work);
      }
      answer = perform(std::stoull(message));
    } catch (const std::exception&) {
      answer = thrown_answer();
    }
    send(status.MPI_SOURCE, answer_tag, answer.dump());
  }
}

}  // namespace secular::app

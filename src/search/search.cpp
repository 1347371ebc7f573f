#include "search/search.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "carom/arithmetic.hpp"

namespace search {

namespace {

constexpr double greatest_error = 1000;  // px

// An exact hand: after a half of the budget the rest is spent near the best shots, ever nearer.
constexpr std::size_t exact_rounds = 4;
// All three are halved before each of these rounds.
constexpr std::size_t refined = 8;  // shots
constexpr int first_turn = 20;      // tenths of a degree
constexpr int first_change = 100;   // px/s

// Two shots that a player would call the same.
bool alike(const Shot& a, const Shot& b) {
  const int turn = std::abs(a.aim.tenths - b.aim.tenths);
  const bool near = std::min(turn, 3600 - turn) < 10 && std::abs(a.aim.speed - b.aim.speed) < 50;
  return near && (!a.place || carom::length(*a.place - *b.place) < 10);
}

carom::Error refusal(std::string what, std::string expected) {
  return {.pointer = std::move(what), .problem = "is wrong", .expected = std::move(expected)};
}

}  // namespace

carom::Result<Search> Search::create(Game game, const Question& question) {
  if (const carom::Status waiting = check_waiting(game); !waiting) return waiting.errors();
  if (question.budget.simulations == 0 || question.budget.shown == 0)
    return refusal("budget", "at least 1 simulation and 1 shot");
  if (!(question.hand.error >= 0 && question.hand.error <= greatest_error))
    return refusal("hand", "an error from 0 to 1000 px");
  Search search(std::make_unique<const Game>(std::move(game)), question);
  if (!search.source_.possible())
    return carom::Error{.problem = "has no free place for the cue ball"};
  search.begin();
  return search;
}

Search::Search(std::unique_ptr<const Game> game, const Question& question)
    : game_(std::move(game)),
      question_(question),
      source_(*game_, random_of(question.seed, Use::proposals)),
      enemies_(std::ranges::count(world_of(*game_).balls().role, carom::Role::enemy)) {}

void Search::begin() {
  const std::uint64_t budget = question_.budget.simulations;
  rounds_ = 1;
  if (question_.hand.exact())
    rounds_ = budget < 2 * refined ? 1 : exact_rounds;
  else
    while ((rounds_ + 1) << (rounds_ + 1) <= budget) ++rounds_;
  begin_round();
}

void Search::add(const Shot& shot) {
  order_.push_back(candidates_.size());
  candidates_.push_back({.shot = shot, .drag = drag(shot.aim), .record = {}});
}

// Exact: every shot is played once, new ones in every round. Otherwise sequential halving: many
// shots are tried a few times each, then the better half of them as often altogether, and so on.
void Search::begin_round() {
  const std::uint64_t left = question_.budget.simulations - simulated_;
  members_.clear();
  next_job_ = 0;
  each_ = 1;
  if (question_.hand.exact()) {
    const std::size_t known = candidates_.size();
    const std::uint64_t count = round_ + 1 == rounds_ ? left : left / 2;
    const std::size_t best = std::min(known, std::max<std::size_t>(1, refined >> round_));
    for (std::uint64_t i = 0; i < count; ++i)
      if (round_ == 0)
        add(source_.next());
      else
        add(source_.near(candidates_[order_[i % best]].shot, first_turn >> round_,
                         first_change >> round_));
    for (std::size_t i = known; i < candidates_.size(); ++i) members_.push_back(i);
    return;
  }
  const std::uint64_t share = left / (rounds_ - round_);
  if (round_ == 0)
    for (std::uint64_t i = 0; i < share; ++i) add(source_.next());
  const std::size_t halved = candidates_.size() >> round_;
  members_.assign(order_.begin(),
                  order_.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(halved, 1)));
  each_ = std::max<std::uint64_t>(share / members_.size(), 1);
}

void Search::end_round() {
  const auto end = question_.hand.exact()
                       ? order_.end()
                       : order_.begin() + static_cast<std::ptrdiff_t>(members_.size());
  std::stable_sort(order_.begin(), end,
                   [this](std::size_t a, std::size_t b) { return better(a, b); });
  sample_ += each_;
  if (++round_ < rounds_)
    begin_round();
  else
    choose();
}

void Search::choose() {
  ranked_.clear();
  members_.clear();
  for (const std::size_t i : order_) {
    if (ranked_.size() == question_.budget.shown) break;
    const Candidate& candidate = candidates_[i];
    if (candidate.record.n == 0 || std::ranges::any_of(ranked_, [&](const Ranked& one) {
          return alike(one.shot, candidate.shot);
        }))
      continue;
    ranked_.push_back({.shot = candidate.shot});
    members_.push_back(i);
    if (question_.hand.exact()) ranked_.back().fresh = candidate.record;
  }
  each_ = question_.budget.fresh;
  next_job_ = 0;
  sample_ = 0;
  stage_ = question_.hand.exact() || each_ == 0 ? Stage::done : Stage::fresh;
}

void Search::advance(std::uint64_t simulations, carom::Rollouts& rollouts) {
  const carom::ExactArithmetic exact;
  while (simulations > 0 && !done()) {
    const std::uint64_t jobs = members_.size() * each_ - next_job_;
    const std::uint64_t now = std::min({simulations, jobs, most_at_once});
    trials_.resize(static_cast<std::size_t>(now));
    play(trials_, rollouts);
    for (const Trial& trial : trials_) {
      const std::size_t member = static_cast<std::size_t>(next_job_++ / each_);
      Record& record =
          stage_ == Stage::fresh ? ranked_[member].fresh : candidates_[members_[member]].record;
      record.add(trial);
    }
    simulations -= now;
    simulated_ += now;
    if (now < jobs) continue;
    if (stage_ == Stage::searching)
      end_round();
    else
      stage_ = Stage::done;
  }
}

void Search::play(std::span<Trial> trials, carom::Rollouts& rollouts) {
  const Use use = stage_ == Stage::fresh ? Use::fresh : Use::searching;
  rollouts.run(world_of(*game_), trials, [this, use](carom::World& world, std::size_t k) {
    const std::uint64_t job = next_job_ + k;
    const std::size_t index = members_[static_cast<std::size_t>(job / each_)];
    const Candidate& candidate = candidates_[index];
    games::Random random = random_of(question_.seed, use, index, sample_ + job % each_);
    return simulate(world, candidate.shot.place, launched(candidate.drag, question_.hand, random));
  });
}

Answer Search::answer() const {
  Answer answer{.ranked = ranked_, .simulations = simulated_};
  if (stage_ != Stage::searching) return answer;
  std::size_t best = order_.front();
  // Within the first round nothing is in order yet.
  if (round_ == 0) {
    if (candidates_[best].record.n == 0) return answer;
    for (const std::size_t i : order_)
      if (candidates_[i].record.n > 0 && better(i, best)) best = i;
  }
  answer.ranked.push_back({.shot = candidates_[best].shot});
  return answer;
}

double Search::worth(const Record& record) const {
  const std::int64_t sum =
      enemies_ > 0 ? record.enemies_out + enemies_ * static_cast<std::int64_t>(record.cleared)
                   : record.points;
  return static_cast<double>(sum) / static_cast<double>(record.n);
}

// Both have been played.
bool Search::better(std::size_t a, std::size_t b) const {
  const Record& x = candidates_[a].record;
  const Record& y = candidates_[b].record;
  if (worth(x) != worth(y)) return worth(x) > worth(y);
  if (x.touched * y.n != y.touched * x.n) return x.touched * y.n > y.touched * x.n;
  return x.fouls * y.n < y.fouls * x.n;
}

}  // namespace search

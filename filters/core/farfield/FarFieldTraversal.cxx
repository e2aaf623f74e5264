// SPDX-FileCopyrightText: Copyright (c) 2026, the Winding authors
// SPDX-License-Identifier: BSD-3-Clause
#include "farfield/FarFieldTraversal.h"

#include "farfield/Expansions.h"

#include <algorithm>
#include <cmath>

namespace winding
{

namespace
{

/// The offset between two places. One beyond farthestOffset is cut off, for all values have long
/// been 0 there.
Eigen::Vector3f offsetBetween(const Eigen::Vector3d& to, const Eigen::Vector3d& from)
{
  return (to - from).cwiseMax(-farthestOffset).cwiseMin(farthestOffset).cast<float>();
}

/// Nodes larger than this times a cell are replaced by their children, smaller ones are left to
/// smaller cells.
constexpr double splitRatio = 1.2;

/// A sum takes no less time for fewer samples than this. It is the number of lanes of the widest
/// vectors on all machines, so that all of them decide alike.
constexpr std::size_t lanesOfSums = 8;

/// The approximate cost of the value of a node's moments at one sample.
double secondsPerValue(int order)
{
  return 0.1e-9 * coefficientCount(order);
}

/// The share of the direct sum's time that cells may spend on nodes without an assured gain. A cell
/// that would spend more is given up: its samples get the sum of the whole sources.
constexpr double mostSpent = 0.15;

} // namespace

FarFieldTraversal::FarFieldTraversal(const FarFieldTree& tree, const TargetCells& cells)
  : tree_(tree)
  , cells_(cells)
{
  const FarFieldSources& sources = *tree.sources;
  const auto coefficients = static_cast<double>(coefficientCount(tree.order()));
  secondsPerLook_ = sources.secondsPerLook();
  secondsPerTranslation_ = sources.secondsPerTranslation() * coefficients * coefficients;
  // Fewer samples than a vector has lanes take as long as a vector of them.
  const std::size_t samples = std::max<std::size_t>(cells.root().allSamples, 1);
  secondsOfWhole_ = sources.secondsPerPair() *
                    static_cast<double>(sources.wholeSize() * roundUp(samples, lanesOfSums)) /
                    static_cast<double>(samples);
}

FarFieldWork FarFieldTraversal::evaluate(
  const FarFieldTask& task, bool watching, std::vector<TargetCell>* toWhole)
{
  watching_ = watching;
  std::vector<TargetCell> ours;
  const bool keepsOurs = cells_.isRegular() || !toWhole;
  toWhole_ = keepsOurs ? &ours : toWhole;
  this->start(task);
  if (!toWhole_->empty() && (keepsOurs || toWhole_->size() >= SampleBlock::capacity))
  {
    this->evaluateWhole(toWhole_->data(), toWhole_->data() + toWhole_->size(), watching);
    toWhole_->clear();
  }
  return work_;
}

void FarFieldTraversal::visit(const FarFieldTask& task, FarFieldLeafVisitor& visitor)
{
  visitor_ = &visitor;
  this->start(task);
}

void FarFieldTraversal::start(const FarFieldTask& task)
{
  nodes_ = task.nodes;
  Local local;
  std::copy(task.local.begin(), task.local.end(), local.values);
  this->descend(task.cell, local, 0, task.spent);
}

FarFieldWork FarFieldTraversal::collect(int level, std::vector<FarFieldTask>& tasks)
{
  tasks_ = &tasks;
  lastLevel_ = level;
  nodes_.assign(tree_.empty() ? 0 : 1, 0);
  Local local = {};
  this->descend(cells_.root(), local, 0, 0);
  return work_;
}

/// Evaluates a cell, or cuts it. From `firstNode` on, nodes_ holds what the parent could not deal
/// with. `local` is the expansion that it handed down. `spent` counts the seconds that the cells
/// above have taken for each sample.
void FarFieldTraversal::descend(
  const TargetCell& cell, Local& local, std::size_t firstNode, double spent)
{
  if (tasks_ && cell.level <= lastLevel_)
  {
    tasks_->push_back({cell, {std::begin(local.values), std::end(local.values)},
      {nodes_.begin() + static_cast<std::ptrdiff_t>(firstNode), nodes_.end()}, spent});
    return;
  }
  ++work_.cells;
  const std::size_t firstKept = nodes_.size();
  accepted_.clear();
  bool isGivenUp = this->isTooMuch(spent + this->secondsOfLooks(firstKept - firstNode, cell));
  if (!isGivenUp)
  {
    const std::uint64_t before = work_.nodeTests;
    this->classify(cell, firstNode);
    spent += this->secondsOfLooks(work_.nodeTests - before, cell);
    isGivenUp = this->isHopeless(cell, firstKept, spent);
  }
  if (isGivenUp)
  {
    // All cells below are given up, too.
    accepted_.clear();
    nodes_.resize(firstKept);
    spent = HUGE_VAL;
  }
  spent += this->secondsOfAccepted(cell);
  if (tasks_ || this->isWorthCutting(cell, firstKept, spent))
  {
    this->addAccepted(cell, local);
    this->descendToChildren(cell, local, firstKept, spent);
  }
  else
  {
    this->evaluateLeaf(cell, local, firstKept, isGivenUp);
  }
  nodes_.resize(firstKept);
}

/// Evaluates the samples of a cell that is not cut; `local` and `firstKept` are as for descend().
void FarFieldTraversal::evaluateLeaf(
  const TargetCell& cell, Local& local, std::size_t firstKept, bool isGivenUp)
{
  ++work_.leaves;
  const int order = tree_.order();
  const bool hasKept = firstKept < nodes_.size();
  bool isWhole = isGivenUp;
  if (!isWhole && (hasKept || visitor_))
  {
    isWhole = !this->collectNear(cell, firstKept) || this->isCheaperWhole(cell.allSamples);
  }
  alignas(64) float polynomial[polynomialRows(largestOrder)];
  if (isWhole)
  {
    byMoments_.clear();
    exactly_ = tree_.sources->whole();
  }
  else
  {
    this->addAccepted(cell, local);
    multiplyMatrix(tree_.toPolynomial.data(), polynomialRows(order),
      static_cast<std::size_t>(coefficientCount(order)), local.values, polynomial);
  }
  if (visitor_)
  {
    visitor_->visit({cell, isWhole ? nullptr : polynomial, byMoments_, exactly_});
  }
  else if (isWhole && toWhole_ && cell.samples < SampleBlock::capacity)
  {
    toWhole_->push_back(cell);
  }
  else if (isWhole || hasKept)
  {
    this->evaluateNear(cell, isWhole ? nullptr : polynomial);
  }
  else
  {
    const std::size_t rows = cells_.rowsOf(cell);
    work_.rows += rows;
    std::uint64_t& samples = rows > 0 ? work_.rowSamples : work_.blockSamples;
    samples += cell.samples;
    cells_.storePolynomial(cell, order, polynomial);
  }
}

/// Returns whether `seconds` for each sample are more than may be spent without an assured gain.
bool FarFieldTraversal::isTooMuch(double seconds) const
{
  return seconds > mostSpent * secondsOfWhole_;
}

/// Returns the seconds that looks at nodes take for each sample of a cell.
double FarFieldTraversal::secondsOfLooks(std::uint64_t looks, const TargetCell& cell) const
{
  return secondsPerLook_ * static_cast<double>(looks) / static_cast<double>(cell.allSamples);
}

/// Returns the seconds that the accepted nodes take for each sample of a cell.
double FarFieldTraversal::secondsOfAccepted(const TargetCell& cell) const
{
  return secondsPerTranslation_ * static_cast<double>(accepted_.size()) /
         static_cast<double>(cell.allSamples);
}

/// Returns the number of items of the nodes that are kept.
std::size_t FarFieldTraversal::itemsKept(std::size_t firstKept) const
{
  std::size_t items = 0;
  for (std::size_t i = firstKept; i < nodes_.size(); ++i)
  {
    items += tree_.nodes()[static_cast<std::size_t>(nodes_[i])].size();
  }
  return items;
}

/// Returns whether a cell that has spent much would gain nothing as a leaf. `spent` is as for
/// descend(), with the looks of this cell.
bool FarFieldTraversal::isHopeless(
  const TargetCell& cell, std::size_t firstKept, double spent) const
{
  const double far = this->secondsOfAccepted(cell);
  const double looks = this->secondsOfLooks(nodes_.size() - firstKept, cell);
  const double near =
    static_cast<double>(this->itemsKept(firstKept)) * tree_.sources->secondsPerPair();
  return this->isTooMuch(spent + far + looks) && far + near >= secondsOfWhole_;
}

/// Lists the nodes that act through expansions in accepted_, and appends those left to smaller
/// cells to nodes_.
void FarFieldTraversal::classify(const TargetCell& cell, std::size_t firstNode)
{
  const TargetLevel& level = cells_.level(cell.level);
  const FarFieldAccuracy& accuracy = tree_.accuracy;
  const Eigen::Vector3f center = offsetBetween(cell.center, tree_.moments.origin);
  CellCriteria criteria;
  criteria.x = center[0];
  criteria.y = center[1];
  criteria.z = center[2];
  criteria.radius = static_cast<float>(level.radius);
  criteria.reach = CellCriteria::reachOf(accuracy.order, level.radius);
  criteria.inverseTheta = 1 / accuracy.theta;
  criteria.momentMargin = accuracy.momentMargin();
  criteria.splitRadius = static_cast<float>(splitRatio * std::max(level.radius, 0.25 * level.side));

  accepted_.clear();
  candidates_.assign(nodes_.begin() + static_cast<std::ptrdiff_t>(firstNode), nodes_.end());
  while (!candidates_.empty())
  {
    const std::size_t count = candidates_.size(), kept = nodes_.size(), accepted = accepted_.size();
    accepted_.resize(accepted + count + nodeListSlack);
    split_.resize(count + nodeListSlack);
    nodes_.resize(kept + count + nodeListSlack);
    NodeLists lists{accepted_.data() + accepted, split_.data(), nodes_.data() + kept};
    work_.nodeTests += count;
    classifyNodes(tree_.moments.criteria, criteria, candidates_.data(), count, lists);
    accepted_.resize(accepted + lists.acceptedCount);
    nodes_.resize(kept + lists.keptCount);

    candidates_.clear();
    for (std::size_t i = 0; i < lists.splitCount; ++i)
    {
      const SourceNode& node = tree_.nodes()[static_cast<std::size_t>(split_[i])];
      for (std::uint32_t child = 0; child < node.children; ++child)
      {
        candidates_.push_back(static_cast<std::int32_t>(node.firstChild + child));
      }
    }
  }
}

/// Adds what the accepted nodes give to a cell's local expansion.
void FarFieldTraversal::addAccepted(const TargetCell& cell, Local& local)
{
  if (accepted_.empty())
  {
    return;
  }
  ++work_.receivers;
  work_.translations += accepted_.size();
  LocalSums sums;
  std::fill_n(sums.lanes, coefficientCount(tree_.order()) * 16, 0.0f);
  const SourceMoments& moments = tree_.moments;
  for (std::size_t first = 0; first < accepted_.size(); first += NodeBatch::capacity)
  {
    NodeBatch batch;
    batch.count = std::min(NodeBatch::capacity, accepted_.size() - first);
    for (std::size_t i = 0; i < batch.count; ++i)
    {
      const auto node = static_cast<std::size_t>(accepted_[first + i]);
      const Eigen::Vector3f offset = offsetBetween(cell.center, moments.centers[node]);
      batch.node[i] = accepted_[first + i];
      batch.dx[i] = offset[0];
      batch.dy[i] = offset[1];
      batch.dz[i] = offset[2];
      batch.radius[i] = moments.criteria.radius[node];
    }
    ++work_.translationBatches;
    translateMoments(tree_.order(), moments.moments.data(), batch,
      static_cast<float>(cells_.level(cell.level).side), sums);
  }
  addLanes(tree_.order(), sums, local.values);
}

/// Returns whether smaller cells are expected to save more than they cost. `spent` is as for
/// descend(), with all of this cell.
bool FarFieldTraversal::isWorthCutting(
  const TargetCell& cell, std::size_t firstKept, double spent) const
{
  // Each of the smaller cells looks at all nodes that are kept, which are thousands in a soup.
  constexpr double smallerCells = 8;
  const double looks = smallerCells * this->secondsOfLooks(nodes_.size() - firstKept, cell);
  if (cell.level == 0 || this->isTooMuch(spent + looks))
  {
    return false;
  }
  // A leaf costs no more than the sum of the whole sources. Where it costs as much, smaller cells
  // may save nothing, so that they must cost little in comparison.
  constexpr double ofWhole = 0.25;
  const std::size_t items = this->itemsKept(firstKept), whole = tree_.sources->wholeSize();
  const double saved = (items < whole ? static_cast<double>(items) : ofWhole * whole) *
                       tree_.sources->secondsPerPair();
  return saved > looks &&
         saved * static_cast<double>(cell.allSamples) >
           tree_.sources->secondsPerCutAndCoefficient() * coefficientCount(tree_.order());
}

/// Returns whether the sum of the whole sources is cheaper than what collectNear() has collected: a
/// sample may be near to more pieces of large triangles than there are triangles. Few samples of an
/// irregular cell leave the last vector of a sum half empty, but not where evaluateWhole() takes
/// them together with others.
bool FarFieldTraversal::isCheaperWhole(std::size_t samples) const
{
  const double perPair = tree_.sources->secondsPerPair();
  const double perSample = static_cast<double>(itemsIn(exactly_)) * perPair +
                           static_cast<double>(byMoments_.size()) * secondsPerValue(tree_.order());
  const bool isIrregular = toWhole_ && !cells_.isRegular();
  const auto summed = static_cast<double>(isIrregular ? roundUp(samples, lanesOfSums) : samples);
  const double expansions = secondsPerTranslation_ * static_cast<double>(accepted_.size());
  return perSample * summed + expansions >
         static_cast<double>(tree_.sources->wholeSize() * samples) * perPair;
}

void FarFieldTraversal::descendToChildren(
  const TargetCell& cell, const Local& local, std::size_t firstKept, double spent)
{
  TargetCells::Child children[8];
  const int count = cells_.childrenOf(cell, children);
  const std::size_t rows = paddedCoefficients(tree_.order());
  work_.shifts += static_cast<std::uint64_t>(count);
  for (int i = 0; i < count; ++i)
  {
    const LocalShifts& shifts = *cells_.level(cell.level - 1).fromParent;
    Local shifted;
    multiplyMatrix(shifts.matrices[children[i].octant].data(), rows,
      static_cast<std::size_t>(coefficientCount(tree_.order())), local.values, shifted.values);
    this->descend(children[i].cell, shifted, firstKept, spent);
  }
}

/// Sorts the nodes that were kept, and those below them, into nodes that act through their moments
/// and items that are summed one by one. Returns false as soon as these are more than the whole
/// sources, which are cheaper then.
bool FarFieldTraversal::collectNear(const TargetCell& cell, std::size_t firstKept)
{
  byMoments_.clear();
  exactly_.clear();
  stack_.assign(nodes_.rbegin(), nodes_.rend() - static_cast<std::ptrdiff_t>(firstKept));
  const TargetSphere sphere = cells_.sphereOf(cell);
  const Eigen::Vector3f center = offsetBetween(sphere.center, tree_.moments.origin);
  const auto radius = static_cast<float>(sphere.radius);
  const NodeCriteria& nodes = tree_.moments.criteria;
  const double perValue = secondsPerValue(tree_.order());
  const double perPair = tree_.sources->secondsPerPair();
  std::size_t items = 0;
  while (!stack_.empty())
  {
    const auto number = static_cast<std::size_t>(stack_.back());
    stack_.pop_back();
    ++work_.nearTests;
    const SourceNode& node = tree_.nodes()[number];
    const float dx = center[0] - nodes.x[number], dy = center[1] - nodes.y[number],
                dz = center[2] - nodes.z[number];
    const float needed =
      radius + std::max(tree_.accuracy.momentMargin() * nodes.radius[number], nodes.rho[number]);
    const bool isFar = dx * dx + dy * dy + dz * dz >= needed * needed;
    if (isFar && node.size() * perPair > perValue)
    {
      byMoments_.push_back(static_cast<std::int32_t>(number));
    }
    else if (isFar || node.children == 0)
    {
      items += node.size();
      if (items > tree_.sources->wholeSize())
      {
        return false;
      }
      if (!exactly_.empty() && exactly_.back().end == node.begin)
      {
        exactly_.back().end = node.end;
      }
      else
      {
        exactly_.push_back({node.begin, node.end});
      }
    }
    else
    {
      for (std::uint32_t child = node.children; child-- > 0;)
      {
        stack_.push_back(static_cast<std::int32_t>(node.firstChild + child));
      }
    }
  }
  return true;
}

void FarFieldTraversal::countNear(const TargetCell& cell)
{
  ++work_.nearLeaves;
  work_.nearSamples += cell.samples;
  work_.exactSamples += exactly_.empty() ? 0 : cell.samples;
  work_.momentValues += byMoments_.size() * cell.samples;
  work_.exactPairs += itemsIn(exactly_) * cell.samples;
  work_.exactLanes += itemsIn(exactly_) * roundUp(cell.samples, lanesOfSums);
}

/// `polynomial` is null where nothing acts through expansions.
void FarFieldTraversal::evaluateNear(const TargetCell& cell, const float* polynomial)
{
  this->countNear(cell);
  const int order = tree_.order();
  TargetBlock block;
  alignas(64) float far[SampleBlock::capacity];
  double near[SampleBlock::capacity];
  bool isSuspect[SampleBlock::capacity];
  for (std::size_t first = 0; first < cell.samples; first += block.samples.count)
  {
    cells_.fill(cell, first, block);
    const std::size_t count = block.samples.count;
    const std::size_t padded = roundUp(count, floatLanes);
    std::fill(block.u + count, block.u + padded, 0.0f);
    std::fill(block.v + count, block.v + padded, 0.0f);
    std::fill(block.w + count, block.w + padded, 0.0f);
    if (polynomial)
    {
      evaluatePolynomial(order, polynomial, block.u, block.v, block.w, count, far);
    }
    else
    {
      std::fill_n(far, padded, 0.0f);
    }
    for (const std::int32_t number : byMoments_)
    {
      const auto node = static_cast<std::size_t>(number);
      const Eigen::Vector3d& center = tree_.moments.centers[node];
      addMomentValues(order, tree_.moments.of(node), {center[0], center[1], center[2]},
        tree_.moments.criteria.radius[node], block.samples, far);
    }
    bool any = false;
    if (!exactly_.empty())
    {
      any = tree_.sources->sum(exactly_, block.samples, near, watching_ ? isSuspect : nullptr);
      for (std::size_t i = 0; i < count; ++i)
      {
        far[i] = static_cast<float>(far[i] + near[i]);
      }
    }
    cells_.store(cell, first, count, far, any ? isSuspect : nullptr);
  }
}

FarFieldWork FarFieldTraversal::evaluateWhole(
  const TargetCell* first, const TargetCell* last, bool watching)
{
  struct Part
  {
    const TargetCell* cell;
    std::size_t first, count;
  };
  std::vector<Part> parts;
  SampleBlock block;
  const std::size_t whole = tree_.sources->wholeSize();
  const auto flush = [&]
  {
    work_.exactLanes += whole * roundUp(block.count, lanesOfSums);
    double sums[SampleBlock::capacity];
    bool isSuspect[SampleBlock::capacity];
    const bool any =
      tree_.sources->sum(tree_.sources->whole(), block, sums, watching ? isSuspect : nullptr);
    float values[SampleBlock::capacity];
    std::transform(
      sums, sums + block.count, values, [](double sum) { return static_cast<float>(sum); });
    std::size_t from = 0;
    for (const Part& part : parts)
    {
      cells_.store(
        *part.cell, part.first, part.count, values + from, any ? isSuspect + from : nullptr);
      from += part.count;
    }
    parts.clear();
    block.count = 0;
  };
  TargetBlock own;
  for (const TargetCell* cell = first; cell != last; ++cell)
  {
    ++work_.nearLeaves;
    work_.nearSamples += cell->samples;
    work_.exactSamples += cell->samples;
    work_.exactPairs += whole * cell->samples;
    for (std::size_t done = 0; done < cell->samples; done += own.samples.count)
    {
      cells_.fill(*cell, done, own);
      if (block.count + own.samples.count > SampleBlock::capacity)
      {
        flush();
      }
      parts.push_back({cell, done, own.samples.count});
      std::copy_n(own.samples.x, own.samples.count, block.x + block.count);
      std::copy_n(own.samples.y, own.samples.count, block.y + block.count);
      std::copy_n(own.samples.z, own.samples.count, block.z + block.count);
      block.count += own.samples.count;
    }
  }
  flush();
  return work_;
}

} // namespace winding

// EcoControlMpc as a node, every 500 ms.

#include <algorithm>
#include <memory>

#include "EcoControlMpc.h"
#include "eco_control_baseline/cyclic_node.hpp"
#include "eco_control_baseline/measuring.hpp"
#include "eco_control_baseline/supervision.hpp"
#include "eco_control_interfaces/msg/adas_cruise_control_speed_set.hpp"
#include "eco_control_interfaces/msg/adas_eco_control_is_enabled.hpp"
#include "eco_control_interfaces/msg/adas_map_horizon_altitude.hpp"
#include "eco_control_interfaces/msg/eco_control_mpc_cycle500ms.hpp"
#include "eco_control_interfaces/msg/eco_control_mpc_mode_in.hpp"
#include "eco_control_interfaces/msg/eco_control_mpc_mode_out.hpp"
#include "eco_control_interfaces/msg/safety_reaction.hpp"
#include "eco_control_interfaces/msg/speed.hpp"

namespace eco_control_baseline
{

using namespace eco_control_interfaces::msg;  // NOLINT

constexpr double kMetresPerSecond = 1.0 / 3.6;

class EcoControlMpcNode : public CyclicNode
{
public:
  EcoControlMpcNode()
  : CyclicNode("eco_control_mpc", 500U * kMillisecond, 10U * kMillisecond)
  {
    declare_parameter<double>("veh_m", 2495.0);
    declare_parameter<double>("horizon_step", 20.0);
    declare_parameter<double>("energy_weight", 0.6);
  }

private:
  template<typename Message>
  using Publisher = std::shared_ptr<rclcpp_lifecycle::LifecyclePublisher<Message>>;

  void initialize() override
  {
    inputs_ = ExtU_EcoControlMpc_T{};
    outputs_ = ExtY_EcoControlMpc_T{};
    states_ = DW_EcoControlMpc_T{};
    parameters_.VehM = static_cast<float>(get_parameter("veh_m").as_double());
    parameters_.HorizonStep = static_cast<float>(get_parameter("horizon_step").as_double());
    parameters_.EnergyWeight = static_cast<float>(get_parameter("energy_weight").as_double());
    model_.defaultParam = &parameters_;
    model_.inputs = &inputs_;
    model_.outputs = &outputs_;
    model_.dwork = &states_;
    EcoControlMpc_initialize(&model_);
  }

  void terminate() override {EcoControlMpc_terminate(&model_);}

  void connect() override
  {
    values_ = create_publisher<EcoControlMpcCycle500ms>("eco_control_mpc/cycle500_ms", for_values());
    horizon_ = create_publisher<ErrorStatus>("eco_control_mpc/horizon_timeout", for_states());
    no_solution_ = create_publisher<ErrorStatus>("eco_control_mpc/no_solution_error", for_states());
    deadline_ = create_publisher<ErrorStatus>("eco_control_mpc/deadline_error", for_states());
    reaction_ = create_publisher<SafetyReaction>("eco_control_mpc/acc_prop_invalid", for_states());
    mode_out_ = create_publisher<EcoControlMpcModeOut>("eco_control_mpc/mode_out", for_states());
    listen<ADASEcoControlIsEnabled>(
      "vehicle/adas/eco_control/is_enabled", for_values(),
      [this](const ADASEcoControlIsEnabled & message) {inputs_.EnaMpc = message.is_enabled;});
    listen<Speed>(
      "vehicle/speed", for_values(), [this](const Speed & message) {
        inputs_.EgoSpd = static_cast<float>(static_cast<double>(message.speed) * kMetresPerSecond);
      });
    listen<ADASCruiseControlSpeedSet>(
      "vehicle/adas/cruise_control/speed_set", for_values(),
      [this](const ADASCruiseControlSpeedSet & message) {
        inputs_.SetSpd = static_cast<float>(static_cast<double>(message.speed_set) * kMetresPerSecond);
      });
    listen<ADASMapHorizonAltitude>(
      "vehicle/adas/map/horizon/altitude", for_values(), [this](const ADASMapHorizonAltitude & message) {
        horizon_timeout_.received(current());
        altitude_ = message.altitude;
        const bool is_valid = std::all_of(
          altitude_.begin(), altitude_.end(), [](float each) {return each >= -500.0F && each <= 9000.0F;});
        if (!is_valid) {
          altitude_.fill(0.0F);
        }
      });
    listen<SafetyReaction>(
      "safety_management/acc_prop_invalid", for_states(),
      [this](const SafetyReaction & message) {is_invalid_outside_ = message.state != 0U;});
    listen<EcoControlMpcModeIn>(
      "eco_control_mpc/mode_in", for_states(), [this](const EcoControlMpcModeIn & message) {
        if (message.mode <= EcoControlMpcMode_ACTIVE) {
          inputs_.ModeReq = message.mode;
          set_on(message.mode != EcoControlMpcMode_OFF);
        }
      });
  }

  void disconnect() override
  {
    values_.reset();
    horizon_.reset();
    no_solution_.reset();
    deadline_.reset();
    reaction_.reset();
    mode_out_.reset();
  }

  void start(uint64_t /* now */) override
  {
    tell_reaction();
    tell_mode();
  }

  void step(uint64_t now) override
  {
    measuring_.at(0, now);
    judge(now);
    measuring_.at(1, now);
    EcoControlMpc_step(&model_);
    measuring_.at(2, now);
    const uint64_t end = current();
    deadline_error_.update(end - now > 400U * kMillisecond, false, end);
    no_solution_error_.update(outputs_.NoSolution != 0, horizon_error_.has_failed(), end);
    measuring_.at(3, now);
    EcoControlMpcCycle500ms message;
    message.acceleration_proposal = outputs_.EcoAccProp;
    send(values_, message);
    tell_news(horizon_, horizon_error_);
    tell_news(no_solution_, no_solution_error_);
    tell_news(deadline_, deadline_error_);
    if (is_invalid_ != told_invalid_) {
      tell_reaction();
    }
    if (outputs_.ModeSts != told_mode_) {
      tell_mode();
    }
  }

  void judge(uint64_t now)
  {
    horizon_timeout_.judge(entered(), now);
    if (horizon_timeout_.is_expired()) {
      std::fill_n(inputs_.HorizonAlt, EcoControlMpc_POINTS, 0.0F);
    } else {
      std::copy(altitude_.begin(), altitude_.end(), inputs_.HorizonAlt);
    }
    horizon_error_.update(horizon_timeout_.verdict(), false, now);
    Error told = horizon_error_;  // the function has it in the step in which it is reported
    inputs_.HorizonTmo = told.news().value_or(horizon_error_.told());
    inputs_.NoSolutionSts = no_solution_error_.told();
    inputs_.DeadlineSts = deadline_error_.told();
    is_invalid_ = no_solution_error_.has_failed() || deadline_error_.has_failed() || is_invalid_outside_;
    inputs_.AccPropInvalid = is_invalid_ ? 1U : 0U;
  }

  void tell_news(const Publisher<ErrorStatus> & publisher, Error & error)
  {
    if (const auto news = error.news()) {
      tell(publisher, *news);
    }
  }

  void tell_reaction()
  {
    told_invalid_ = is_invalid_;
    SafetyReaction message;
    message.state = is_invalid_ ? SafetyReaction::ACTIVE : SafetyReaction::INACTIVE;
    send(reaction_, message);
  }

  void tell_mode()
  {
    told_mode_ = outputs_.ModeSts;
    EcoControlMpcModeOut message;
    message.mode = told_mode_;
    send(mode_out_, message);
  }

  RT_MODEL_EcoControlMpc_T model_{};
  P_EcoControlMpc_T parameters_{};
  ExtU_EcoControlMpc_T inputs_{};
  ExtY_EcoControlMpc_T outputs_{};
  DW_EcoControlMpc_T states_{};
  Publisher<EcoControlMpcCycle500ms> values_;
  Publisher<ErrorStatus> horizon_, no_solution_, deadline_;
  Publisher<SafetyReaction> reaction_;
  Publisher<EcoControlMpcModeOut> mode_out_;
  ReceptionTimeout horizon_timeout_{2000U * kMillisecond};
  Error horizon_error_{2000U * kMillisecond, 1000U * kMillisecond};
  Error no_solution_error_{1000U * kMillisecond, 0U};
  Error deadline_error_{1000U * kMillisecond, 0U};
  ADASMapHorizonAltitude::_altitude_type altitude_{};
  bool is_invalid_ = false, told_invalid_ = false, is_invalid_outside_ = false;
  uint8_t told_mode_ = 0;
  Measuring measuring_{"EcoControlMpc"};
};

}  // namespace eco_control_baseline

int main(int argc, char ** argv)
{
  return eco_control_baseline::run_node(
    argc, argv, [] {return std::make_shared<eco_control_baseline::EcoControlMpcNode>();});
}

// CoreAcc as a node, every 50 ms.

#include <cmath>
#include <memory>

#include "CoreAcc.h"
#include "eco_control_baseline/cyclic_node.hpp"
#include "eco_control_baseline/measuring.hpp"
#include "eco_control_baseline/supervision.hpp"
#include "eco_control_interfaces/msg/acceleration_longitudinal.hpp"
#include "eco_control_interfaces/msg/adas_cruise_control_speed_set.hpp"
#include "eco_control_interfaces/msg/adas_eco_control_is_enabled.hpp"
#include "eco_control_interfaces/msg/adas_map_dfs_map_data_spd_unit_typ.hpp"
#include "eco_control_interfaces/msg/adas_obstacle_detection_front_center_distance.hpp"
#include "eco_control_interfaces/msg/chassis_brake_cyl_p.hpp"
#include "eco_control_interfaces/msg/chassis_steering_whl_ag.hpp"
#include "eco_control_interfaces/msg/core_acc_cycle50ms.hpp"
#include "eco_control_interfaces/msg/core_acc_mode_in.hpp"
#include "eco_control_interfaces/msg/core_acc_mode_out.hpp"
#include "eco_control_interfaces/msg/eco_control_mpc_cycle500ms.hpp"
#include "eco_control_interfaces/msg/mass.hpp"
#include "eco_control_interfaces/msg/safety_reaction.hpp"
#include "eco_control_interfaces/msg/speed.hpp"

namespace eco_control_baseline
{

using namespace eco_control_interfaces::msg;  // NOLINT

constexpr double kMetresPerSecond = 1.0 / 3.6;

class CoreAccNode : public CyclicNode
{
public:
  CoreAccNode()
  : CyclicNode("core_acc", 50U * kMillisecond, 0U)
  {
    declare_parameter<double>("a_lat_max", 3.0);
  }

private:
  template<typename Message>
  using Publisher = std::shared_ptr<rclcpp_lifecycle::LifecyclePublisher<Message>>;

  void initialize() override
  {
    core_inputs = core_inputs_T{};
    auto & vehicle = core_inputs.bus_ACCIn.Bus_Veh;
    vehicle.SteerWhlAg = -16.0;
    vehicle.EgoVehALgt = -20.0;
    core_inputs.bus_ACCIn.Bus_Cust.EgoVehMass = 2495.0;
    core_inputs.bus_MPCOut.EcoAccProp = -20.0F;
    core_params.ALatMax = static_cast<float>(get_parameter("a_lat_max").as_double());
    CoreAcc_initialize();
  }

  void terminate() override {CoreAcc_terminate();}

  void connect() override
  {
    values_ = create_publisher<CoreAccCycle50ms>("core_acc/cycle50_ms", for_values());
    brake_ = create_publisher<ErrorStatus>("core_acc/brake_pressure_timeout", for_states());
    steering_ = create_publisher<ErrorStatus>("core_acc/steering_angle_timeout", for_states());
    proposal_ = create_publisher<ErrorStatus>("core_acc/proposal_timeout", for_states());
    alive_ = create_publisher<ErrorStatus>("core_acc/alive_error", for_states());
    reaction_ = create_publisher<SafetyReaction>("core_acc/acc_req_invalid", for_states());
    mode_out_ = create_publisher<CoreAccModeOut>("core_acc/mode_out", for_states());
    connect_values();
    connect_states();
  }

  void connect_values()
  {
    auto & vehicle = core_inputs.bus_ACCIn.Bus_Veh;
    auto & driver = core_inputs.bus_ACCIn.Bus_Cust;
    listen<ChassisBrakeCylP>(
      "vehicle/chassis/brake/cyl_p", for_values(), [this, &vehicle](const ChassisBrakeCylP & message) {
        brake_timeout_.received(current());
        vehicle.BrkCylP = within(message.cyl_p, -30.0, 276.9) ? message.cyl_p : 0.0;
      });
    listen<ChassisSteeringWhlAg>(
      "vehicle/chassis/steering/whl_ag", for_values(),
      [this, &vehicle](const ChassisSteeringWhlAg & message) {
        steering_timeout_.received(current());
        vehicle.SteerWhlAg = within(message.whl_ag, -16.0, 16.766) ? message.whl_ag : -16.0;
      });
    listen<AccelerationLongitudinal>(
      "vehicle/acceleration/longitudinal", for_values(),
      [&vehicle](const AccelerationLongitudinal & message) {
        const float value = message.longitudinal;
        const bool is_valid = value >= -20.0F && value <= 20.94F;
        vehicle.EgoVehALgt = is_valid ? static_cast<double>(value) : -20.0;
      });
    listen<Speed>(
      "vehicle/speed", for_values(), [&vehicle](const Speed & message) {
        vehicle.EgoVehSpd = static_cast<double>(message.speed) * kMetresPerSecond;
      });
    listen<Mass>(
      "vehicle/mass", for_values().transient_local(), [&driver](const Mass & message) {
        driver.EgoVehMass = static_cast<double>(message.mass);
      });
    listen<ADASCruiseControlSpeedSet>(
      "vehicle/adas/cruise_control/speed_set", for_values(),
      [&driver](const ADASCruiseControlSpeedSet & message) {
        driver.SetSpd = static_cast<float>(static_cast<double>(message.speed_set) * kMetresPerSecond);
      });
    listen<ADASEcoControlIsEnabled>(
      "vehicle/adas/eco_control/is_enabled", for_values(),
      [&driver](const ADASEcoControlIsEnabled & message) {driver.EnaGACC = message.is_enabled;});
    listen<ADASMapDFSMapDataSpdUnitTyp>(
      "vehicle/adas/map/dfs/map_data_spd_unit_typ", for_values(),
      [&driver](const ADASMapDFSMapDataSpdUnitTyp & message) {take_unit(message, driver);});
    listen<ADASObstacleDetectionFrontCenterDistance>(
      "vehicle/adas/obstacle_detection/front/center/distance", for_values(),
      [](const ADASObstacleDetectionFrontCenterDistance & message) {
        core_inputs.bus_ACCIn.Bus_Obj.ObjDst = message.distance;
      });
    listen<EcoControlMpcCycle500ms>(
      "eco_control_mpc/cycle500_ms", for_values(), [this](const EcoControlMpcCycle500ms & message) {
        proposal_timeout_.received(current());
        proposed_ = message.acceleration_proposal;
      });
  }

  void connect_states()
  {
    listen<ErrorStatus>(
      "eco_control_mpc/no_solution_error", for_states(),
      [this](const ErrorStatus & message) {no_solution_ = message.status;});
    listen<ErrorStatus>(
      "eco_control_mpc/deadline_error", for_states(),
      [this](const ErrorStatus & message) {deadline_ = message.status;});
    listen<SafetyReaction>(
      "safety_management/acc_req_invalid", for_states(),
      [this](const SafetyReaction & message) {is_invalid_outside_ = message.state != 0U;});
    listen<CoreAccModeIn>(
      "core_acc/mode_in", for_states(), [this](const CoreAccModeIn & message) {
        if (message.mode > CoreAccMode_ACTIVE) {
          return;
        }
        const bool was_on = core_inputs.bus_ACCIn.Bus_Sts.ModeReq != CoreAccMode_OFF;
        core_inputs.bus_ACCIn.Bus_Sts.ModeReq = message.mode;
        set_on(message.mode != CoreAccMode_OFF);
        if (!was_on && message.mode != CoreAccMode_OFF) {
          alive_supervision_.begin(next());
        }
      });
  }

  static void take_unit(const ADASMapDFSMapDataSpdUnitTyp & message, Bus_Cust_T & driver)
  {
    switch (message.map_data_spd_unit_typ_number) {
      case ADASMapDFSMapDataSpdUnitTyp::KM_PER_HOUR: driver.EgoVehDshbSpdUnit = SpdUnit_KM_PER_HOUR; break;
      case ADASMapDFSMapDataSpdUnitTyp::MI_PER_HOUR: driver.EgoVehDshbSpdUnit = SpdUnit_MI_PER_HOUR; break;
      case ADASMapDFSMapDataSpdUnitTyp::NOT_IN_MAP: driver.EgoVehDshbSpdUnit = SpdUnit_NOT_IN_MAP; break;
      default: break;
    }
  }

  void disconnect() override
  {
    values_.reset();
    brake_.reset();
    steering_.reset();
    proposal_.reset();
    alive_.reset();
    reaction_.reset();
    mode_out_.reset();
  }

  static bool within(double value, double least, double most) {return value >= least && value <= most;}

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
    CoreAcc_step();
    measuring_.at(2, now);
    const uint64_t end = current();
    alive_supervision_.ended(end);
    alive_error_.update(alive_supervision_.verdict(end), false, end);
    measuring_.at(3, now);
    CoreAccCycle50ms message;
    message.status = AsmAcc_AccIntSts;
    message.acceleration_request = core_outputs.bus_ACCOut.AccReq;
    send(values_, message);
    tell_news(brake_, brake_error_);
    tell_news(steering_, steering_error_);
    tell_news(proposal_, proposal_error_);
    tell_news(alive_, alive_error_);
    if (is_invalid_ != told_invalid_) {
      tell_reaction();
    }
    if (core_outputs.bus_ACCOut.ModeSts != told_mode_) {
      tell_mode();
    }
  }

  void judge(uint64_t now)
  {
    brake_timeout_.judge(entered(), now);
    steering_timeout_.judge(entered(), now);
    proposal_timeout_.judge(entered(), now);
    core_inputs.bus_MPCOut.EcoAccProp = proposal_timeout_.is_expired() ? -20.0F : proposed_;
    brake_error_.update(brake_timeout_.verdict(), false, now);
    steering_error_.update(steering_timeout_.verdict(), false, now);
    const bool is_other_failed = no_solution_.value_or(0U) != 0U || deadline_.value_or(0U) != 0U;
    std::optional<bool> is_missing = proposal_timeout_.verdict();
    if (!is_missing.has_value() && (no_solution_.has_value() || deadline_.has_value())) {
      is_missing = false;
    }
    proposal_error_.update(is_missing, is_other_failed, now);
    auto & states = core_inputs.bus_ACCIn.Bus_Sts;
    states.BrkPTmo = told_next(brake_error_);
    states.SteerAgTmo = told_next(steering_error_);
    states.EcoAccPropTmo = told_next(proposal_error_);
    states.Alive = alive_error_.told();
    is_invalid_ = brake_error_.has_failed() || alive_error_.has_failed() || is_invalid_outside_;
    states.AccReqInvalid = is_invalid_ ? 1U : 0U;
  }

  // The function has it in the step in which it is reported.
  static uint8_t told_next(const Error & error)
  {
    Error copy = error;
    return copy.news().value_or(error.told());
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
    told_mode_ = core_outputs.bus_ACCOut.ModeSts;
    CoreAccModeOut message;
    message.mode = told_mode_;
    send(mode_out_, message);
  }

  Publisher<CoreAccCycle50ms> values_;
  Publisher<ErrorStatus> brake_, steering_, proposal_, alive_;
  Publisher<SafetyReaction> reaction_;
  Publisher<CoreAccModeOut> mode_out_;
  ReceptionTimeout brake_timeout_{200U * kMillisecond};
  ReceptionTimeout steering_timeout_{200U * kMillisecond};
  ReceptionTimeout proposal_timeout_{1500U * kMillisecond};
  AliveSupervision alive_supervision_{500U * kMillisecond, 8U, 12U};
  Error brake_error_{200U * kMillisecond, 500U * kMillisecond};
  Error steering_error_{200U * kMillisecond, 500U * kMillisecond};
  Error proposal_error_{1500U * kMillisecond, 500U * kMillisecond};
  Error alive_error_{0U, 0U, false};
  float proposed_ = -20.0F;
  std::optional<uint8_t> no_solution_, deadline_;
  bool is_invalid_ = false, told_invalid_ = false, is_invalid_outside_ = false;
  uint8_t told_mode_ = 0;
  Measuring measuring_{"CoreAcc"};
};

}  // namespace eco_control_baseline

int main(int argc, char ** argv)
{
  return eco_control_baseline::run_node(
    argc, argv, [] {return std::make_shared<eco_control_baseline::CoreAccNode>();});
}

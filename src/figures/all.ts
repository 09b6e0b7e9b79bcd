import { fallingBall } from './fallingBall.ts'
import { forcesOnSlope } from './forcesOnSlope.ts'
import { massCancels } from './massCancels.ts'
import { criticalAngle } from './criticalAngle.ts'
import { twoBecomeOne } from './twoBecomeOne.ts'
import { areaUnderV } from './areaUnderV.ts'
import { whereDoesItStop } from './whereDoesItStop.ts'
import { chatter } from './chatter.ts'
import { threeStops } from './threeStops.ts'
import { framesAndTicks } from './framesAndTicks.ts'
import { inputAndTicks } from './inputAndTicks.ts'
import { hitch } from './hitch.ts'
import { yourFrames } from './yourFrames.ts'
import { yourEngine } from './yourEngine.ts'
import { coasting } from './coasting.ts'
import { following } from './following.ts'
import { halfPipeEnergy } from './halfPipeEnergy.ts'
import { springLimit } from './springLimit.ts'
import { flungOut } from './flungOut.ts'
import { speedAgainstError } from './speedAgainstError.ts'
import { stepToTolerance } from './stepToTolerance.ts'
import { paperStep } from './paperStep.ts'
import { breakIt } from './breakIt.ts'
import type { Figure } from './shared/figure.ts'

/** All figures, in the order of the tutorial: what is loaded when the first of them comes near. */
export const all: readonly Figure[] = [
  fallingBall,
  forcesOnSlope,
  massCancels,
  criticalAngle,
  twoBecomeOne,
  areaUnderV,
  whereDoesItStop,
  chatter,
  threeStops,
  framesAndTicks,
  inputAndTicks,
  hitch,
  yourFrames,
  yourEngine,
  coasting,
  following,
  halfPipeEnergy,
  springLimit,
  flungOut,
  speedAgainstError,
  stepToTolerance,
  paperStep,
  breakIt,
]

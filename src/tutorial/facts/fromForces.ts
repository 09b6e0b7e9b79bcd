import { simulate } from '../../physics/index.ts'
import { fixed } from '../../chart/numbers.ts'
import type { Facts } from './fact.ts'

const degrees = (value: number) => `${fixed(value, 2)}°`
const steepest = (mu: number) => (Math.atan(mu) * 180) / Math.PI

function setsOff(angle: number, muStatic: number): boolean {
  const parameters = { angle, muStatic, muKinetic: 0.3 }
  return simulate({ scene: 'ramp', parameters, duration: 1 }).outcome.kind === 'moving'
}

/** The steepest angle at which a simulated block stays [°], by bisection. */
function found(muStatic: number): number {
  let stays = 0
  let goes = 90
  while (goes - stays > 1e-9) {
    const angle = (stays + goes) / 2
    if (setsOff(angle, muStatic)) goes = angle
    else stays = angle
  }
  return stays
}

/** The angles at which a block sets off. */
export const fromForces = {
  criticalTheory: { value: () => steepest(0.45), show: degrees },
  criticalFound: { value: () => found(0.45), show: degrees },
  twoAnswersFrom: { value: () => steepest(0.3), show: degrees },
} as const satisfies Facts

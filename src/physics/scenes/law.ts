import type { Law } from '../law.ts'

/** What a scene's law starts from, before it adds its forces. */
type Start = Omit<Law, 'forces'>

/** The law of a block that nothing touches. */
export function freely(mass: number): Start {
  return {
    mass,
    muStatic: 0,
    muKinetic: 0,
    dependsOnSpeed: false,
    turnMatters: false,
    joints: [],
    open: false,
    // What starts at 1e9 m/s at the most and falls at 1e6 m/s² for 1e6 s does not get near it.
    speedLimit: 1e15,
  }
}

/** The law of a block that rubs. Static friction is never taken below kinetic: a block that is held can't be braked into moving. */
export function rubbing(mass: number, muStatic: number, muKinetic: number): Start {
  return {
    ...freely(mass),
    muStatic: Math.max(muStatic, muKinetic),
    muKinetic,
    turnMatters: muStatic > 0 || muKinetic > 0,
  }
}

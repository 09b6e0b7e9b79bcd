import type { Law } from '../law.ts'

/** The law of a block on which nothing acts: what a scene starts from and adds to. */
export function freely(mass: number): Law {
  return {
    forces: [{ drive: 0, press: 0 }],
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
export function rubbing(mass: number, muStatic: number, muKinetic: number): Law {
  return {
    ...freely(mass),
    muStatic: Math.max(muStatic, muKinetic),
    muKinetic,
    turnMatters: muStatic > 0 || muKinetic > 0,
  }
}

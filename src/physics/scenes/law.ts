import type { Law } from '../motion.ts'

/** The law of a block on which nothing acts: what a scene starts from and adds to. */
export function freely(mass: number): Law {
  return {
    forces: () => {},
    mass,
    muStatic: 0,
    muKinetic: 0,
    dependsOnSpeed: false,
    constantPress: true,
    turnMatters: false,
    joints: [],
    open: false,
    // Its square is still a number.
    speedLimit: 1e150,
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

import type { Integrator } from './integrator.ts'
import type { Motion } from './motion.ts'

/**
 * The same integrator, its steps a unit of their own for an engine that compiles them. A call that has met two functions
 * is not compiled into its caller; so all that V8 is willing to compile into one place is left to the integrator's own
 * loop, and no number that this passes on is boxed.
 */
export function unit(integrator: Integrator): Integrator {
  const parts = [note, integrator.step]
  return {
    ...integrator,
    step: (motion) => {
      for (let i = 0; i < parts.length; i++) parts[i]!(motion)
    },
  }
}

function note(motion: Motion): void {
  motion.note()
}

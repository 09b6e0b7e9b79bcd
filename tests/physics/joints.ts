import type { Parameters, Scene } from '../../src/physics/index.ts'

/** Where one piece of a scene's track joins the next [m]. */
export function jointsOf(scene: Scene, parameters: Parameters): number[] {
  const { track } = scene.law(parameters)
  return track.slice(1).map(({ from }) => from)
}

/** Where the track ends beyond which a block has left [m]; Infinity where it has no end. */
export function endOf(scene: Scene, parameters: Parameters): number {
  return scene.law(parameters).track.at(-1)!.to
}

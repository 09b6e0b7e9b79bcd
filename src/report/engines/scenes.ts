import { exact } from '../../physics/index.ts'
import type { FramesChoice } from '../../physics/index.ts'
import type { EngineScene } from '../schema/index.ts'

const gravity = 9.81

/** tan of it is 0.5: at this angle friction of 0.5 just holds a block. */
const critical = (Math.atan(0.5) * 180) / Math.PI

type Given = Omit<EngineScene, 'parameters' | 'truth'> & {
  angle: number
  friction: number
  speed: number
}

function scene({ angle, friction, speed, ...rest }: Given): EngineScene {
  const parameters = {
    angle,
    muStatic: friction,
    muKinetic: friction,
    gravity,
    mass: 1,
    position: 0,
    speed,
  }
  return {
    ...rest,
    parameters,
    truth: exact({ scene: 'ramp', parameters }, rest.duration).s,
  }
}

/** One block on one slope, six times: what every engine can be asked for. */
export const engineScenes: readonly EngineScene[] = [
  scene({
    id: 'slide',
    label: 'Slides',
    about: '30°, μ = 0.2, from rest, 2 s',
    angle: 30,
    friction: 0.2,
    speed: 0,
    duration: 2,
    watchedUntil: null,
    rests: false,
  }),
  scene({
    id: 'flat-stop',
    label: 'Stops on the flat',
    about: '0°, μ = 0.5, 6 m/s, 2 s',
    angle: 0,
    friction: 0.5,
    speed: 6,
    duration: 2,
    watchedUntil: null,
    rests: true,
  }),
  scene({
    id: 'uphill-stays',
    label: 'Uphill, stays',
    about: '20°, μ = 0.5, 5 m/s uphill, 2 s, then watched until 60 s',
    angle: 20,
    friction: 0.5,
    speed: -5,
    duration: 2,
    watchedUntil: 60,
    rests: true,
  }),
  scene({
    id: 'uphill-back',
    label: 'Uphill and back',
    about: '35°, μ = 0.3, 5 m/s uphill, 3 s',
    angle: 35,
    friction: 0.3,
    speed: -5,
    duration: 3,
    watchedUntil: null,
    rests: false,
  }),
  scene({
    id: 'under',
    label: '0.1° too flat to slide',
    about: `${(critical - 0.1).toFixed(2)}°, μ = 0.5, from rest, 60 s`,
    angle: critical - 0.1,
    friction: 0.5,
    speed: 0,
    duration: 60,
    watchedUntil: null,
    rests: true,
  }),
  scene({
    id: 'over',
    label: '0.1° too steep to stay',
    about: `${(critical + 0.1).toFixed(2)}°, μ = 0.5, from rest, 60 s`,
    angle: critical + 0.1,
    friction: 0.5,
    speed: 0,
    duration: 60,
    watchedUntil: null,
    rests: false,
  }),
]

/** The clocks that every engine is given. */
export const engineClocks: readonly { label: string; frames: FramesChoice }[] = [
  ...[10, 30, 60, 144].map((fps) => ({
    label: `${fps} fps`,
    frames: { kind: 'steady', fps } as const,
  })),
  { label: 'jitter', frames: { kind: 'jitter', fps: 60, amount: 0.5, seed: 1 } },
]

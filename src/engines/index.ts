import { unityFixedUpdate } from './unityFixedUpdate.ts'
import { unityUpdate } from './unityUpdate.ts'
import { godot } from './godot.ts'
import { unreal } from './unreal.ts'
import { unrealSubstepping } from './unrealSubstepping.ts'
import { bevy } from './bevy.ts'
import { phaser } from './phaser.ts'
import { matter } from './matter.ts'
import { planck } from './planck.ts'
import { box2d } from './box2d.ts'
import { rapier } from './rapier.ts'
import { gameMaker } from './gameMaker.ts'
import { pico8 } from './pico8.ts'
import { monoGame } from './monoGame.ts'
import { libgdx } from './libgdx.ts'
import { love } from './love.ts'
import { pygame } from './pygame.ts'
import { source } from './source.ts'
import { quake } from './quake.ts'
import { quake3 } from './quake3.ts'

/** Every engine, the most used ones first. */
export const engines = [
  unityFixedUpdate,
  unityUpdate,
  godot,
  unreal,
  unrealSubstepping,
  bevy,
  phaser,
  matter,
  planck,
  box2d,
  rapier,
  gameMaker,
  pico8,
  monoGame,
  libgdx,
  love,
  pygame,
  source,
  quake,
  quake3,
] as const

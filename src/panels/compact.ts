import { Glide } from '../lab/glide.ts'
import { openInLab } from './share/openInLab.ts'
import type { MakeLater } from '../lab/later.ts'
import './strip/defineStrip.ts'

/** Of a lab that is a figure in somebody's page: the way from there to the whole lab. */
export const compact: MakeLater = (lab) => ({
  glide: new Glide(lab),
  below: () => openInLab(lab.simulated.state),
})

import { FigurePicture } from './figurePicture.ts'
import { FramesRecorder } from './framesRecorder.ts'

customElements.define('figure-picture', FigurePicture)
customElements.define('frames-recorder', FramesRecorder)

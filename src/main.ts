import './figure/define.ts'
import { EarlyLinks } from './tutorial/earlyLinks.ts'

const links = new EarlyLinks()
// The lab comes first: the figures are pictures until they are near, and the text needs no script.
void import('./reading.ts').then(() => {
  links.follow()
})

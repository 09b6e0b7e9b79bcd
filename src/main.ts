import './figure/define.ts'
import './figure/defineFigure.ts'

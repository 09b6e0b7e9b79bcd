import './figure/define.ts'

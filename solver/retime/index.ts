export { createRetime, type Retime, type Retimed, type RetimeOptions } from './retime.ts';

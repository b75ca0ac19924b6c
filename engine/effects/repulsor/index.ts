export { letGoTime } from './let-go.ts';
export { repulsor } from './repulsor.ts';
export { comeOffRim, enterField, followRim, leaveField } from './rims.ts';
export { setRim } from './slide.ts';

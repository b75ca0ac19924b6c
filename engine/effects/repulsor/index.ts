export { letGoTime } from './let-go.ts';
export { repulsor } from './repulsor.ts';
export { comeOffRim, enterField, leaveField } from './rims.ts';

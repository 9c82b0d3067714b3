! FRIC, a friction model of Abaqus/Standard: Coulomb's, sticking at a finite stiffness.
!
! PROPS    1       friction coefficient
!          2       stiffness while it sticks: shear traction per slip
! TAU      the shear tractions of the last increment, then of this one; they are the state,
!          and nothing is in STATEV
! DDTDDG   their derivative with respect to the slip increments
! DDTDDP   their derivative with respect to the pressure, which makes the matrix of the
!          whole model unsymmetric while it slips
! NFDIR    one direction or two
!
! Put together from formulas that jointproof proves; free of conditions (CC0-1.0). Compile
! with -ffp-contract=off.
subroutine fric(lm, tau, ddtddg, ddtddp, dslip, sed, sfd, ddtddt, pnewdt, statev, dgam, taulm, &
        press, dpress, ddpddh, slip, kstep, kinc, time, dtime, noel, ciname, slname, msname, &
        npt, node, npatch, coords, rcoord, drot, temp, predef, nfdir, mcrd, npred, nstatv, &
        chrlngth, props, nprops)
{uses}    use jp_runtime, only: dp
    include 'ABA_PARAM.INC'
    integer, intent(in) :: kstep, kinc, noel, npt, node, npatch, nfdir, mcrd, npred, nstatv, &
        nprops
    character(len=80), intent(in) :: ciname, slname, msname
    integer, intent(inout) :: lm
    real(dp), intent(in) :: dslip(nfdir), dgam(nfdir), taulm(nfdir), press, dpress, ddpddh, &
        slip(nfdir), time(2), dtime, coords(mcrd), rcoord(mcrd), drot(2, 2), temp(2), &
        predef(2, *), chrlngth(2), props(nprops)
    real(dp), intent(inout) :: tau(nfdir), ddtddg(nfdir, nfdir), ddtddp(nfdir), sed, sfd, &
        ddtddt(nfdir, 2), pnewdt, statev(*)
    real(dp) :: trial(nfdir), slope(2, 4), limit
    integer :: code

    lm = 0
    limit = max(press, 0.0_dp)
    trial = tau + props(2) * dgam
    slope = 0
    if (nfdir == 1) then
        code = jp_coulomb_return_map_jacobian(trial(1), props(1), limit, tau(1), slope(1:1, 1:3))
    else
        code = jp_coulomb_return_map_2d_jacobian(trial, props(1), limit, tau, slope)
    end if
    if (code /= 0) then
        pnewdt = min(pnewdt, 0.5_dp)
        return
    end if
    ddtddg = slope(:nfdir, :nfdir) * props(2)
    ddtddp = 0
    if (press >= 0) ddtddp = slope(:nfdir, nfdir + 2)
end subroutine fric

! MPC, a multi-point constraint of Abaqus/Standard: SLIDER, which keeps node m on the line
! through nodes 1 and n, in degree of freedom mode.
!
! nodes    m, m, 1, 1, 1, n, n, n in this order: *MPC cards of two types, 1 and 2, for both
!          coordinates that are eliminated
! JTYPE    1 eliminates the first axis, 2 the second; the third is kept. Which they are
!          follows from the line as it is
! LMPC     0 where nodes 1 and n coincide: there is no line
! JDOF     the degrees of freedom of the eight terms
! UE       the displacement that is eliminated
! A        the coefficients of the linearised constraint, in the order of JDOF
!
! Put together from formulas that jointproof proves; free of conditions (CC0-1.0). Compile
! with -ffp-contract=off.
subroutine mpc(ue, a, jdof, mdof, n, jtype, x, u, uinit, maxdof, lmpc, kstep, kinc, time, nt, &
        nf, temp, field, ltran, tran)
{uses}    use jp_runtime, only: dp
    include 'ABA_PARAM.INC'
    integer, intent(in) :: mdof, n, jtype, maxdof, kstep, kinc, nt, nf, ltran(n)
    integer, intent(inout) :: jdof(n), lmpc
    real(dp), intent(in) :: x(6, n), u(maxdof, n), uinit(maxdof, n), time(2), temp(nt, n), &
        field(nf, nt, n), tran(3, 3, n)
    real(dp), intent(inout) :: ue(mdof), a(n)
    real(dp) :: x1(3), xn(3), d(3), found(2), slope(2, 7)
    integer :: axes(3), more, less, eliminated, kept

    x1 = x(1:3, 3) + u(1:3, 3)
    xn = x(1:3, 6) + u(1:3, 6)
    ! The axes as slider.eliminate chooses them.
    {axes}
    eliminated = axes(jtype)
    kept = axes(3)
    if (jp_slider_eliminate_jacobian(x1, xn, x(kept, 2) + u(kept, 2), found(1), found(2), &
        slope) /= 0) then
        lmpc = 0
        return
    end if
    ue(1) = found(jtype) - x(eliminated, 1)
    jdof = [eliminated, kept, 1, 2, 3, 1, 2, 3]
    a = [1.0_dp, -slope(jtype, 7), -slope(jtype, 1:6)]
end subroutine mpc
